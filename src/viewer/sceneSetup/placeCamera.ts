import { MathUtils, Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import type { FileCamera } from '../files/common/ModelExtras.js';
import { type CameraLens, type CameraView, halfHeightOf } from '../settings/CameraView.js';
import { type Framing, fitCamera } from './framing.js';
import { LENS } from './LensCamera.js';

/** Field of view, in degrees, of the nearly orthographic camera that fits an orthographic picture. */
const NARROW = 0.2;
/** Distance of an orthographic camera from its target, in radii of the model: outside the scene. */
const FAR_AWAY = 40;
const UP = new Vector3(0, 1, 0);

/** The direction to an eye, and the up direction of its picture. */
export interface EyeDirection {
  /** From the model to the eye, of any length. */
  toEye: Vector3;
  up: Vector3;
}

/** The direction for an azimuth around the up axis, from the viewer's side to the right, and an elevation above the horizon, in degrees. */
export function eyeDirection(azimuth: number, elevation: number): EyeDirection {
  const [around, above] = [azimuth, elevation].map(MathUtils.degToRad);
  // The cosine of exactly 90° must be 0 in spite of rounding.
  const level = Math.abs(elevation) === 90 ? 0 : Math.cos(above);
  const [x, z] = [Math.sin(around), Math.cos(around)];
  return {
    toEye: new Vector3(level * x, Math.sin(above), level * z),
    up: level === 0 ? new Vector3(x, 0, z).multiplyScalar(-Math.sign(elevation)) : UP.clone(),
  };
}

/** A camera and its target. */
export interface PlacedCamera {
  camera: PerspectiveCamera | OrthographicCamera;
  target: Vector3;
}

/**
 * A camera that frames a model of radius 1.
 *
 * @param aspect of the picture
 * @param framedPoints xyz of points that must be in the picture
 */
export function framedCamera(
  aspect: number,
  framedPoints: ArrayLike<number>,
  { toEye, up }: EyeDirection,
  { isOrthographic, ...framing }: Framing & { isOrthographic: boolean },
): PlacedCamera {
  const fieldOfView = isOrthographic ? NARROW : LENS.fieldOfView;
  const camera = new PerspectiveCamera(fieldOfView, aspect, LENS.near, LENS.far);
  camera.up.copy(up);
  const target = fitCamera(camera, framedPoints, toEye, framing);
  return { camera: isOrthographic ? withoutPerspective(camera, target) : camera, target };
}

/**
 * A camera with the view of a link. Its picture contains the largest square in the middle of the page, or all that a lens of its own shows.
 */
export function linkedCamera(aspect: number, view: CameraView, isOrthographic: boolean): PlacedCamera {
  const { position, target, lens } = view;
  if (lens) return cameraWithLens(aspect, { ...view, lens }, isOrthographic);
  const slope = Math.tan(MathUtils.degToRad(LENS.fieldOfView) / 2) / Math.min(1, aspect);
  const camera = new PerspectiveCamera(2 * MathUtils.radToDeg(Math.atan(slope)), aspect, LENS.near, LENS.far);
  camera.position.fromArray(position);
  const lookedAt = new Vector3().fromArray(target);
  camera.lookAt(lookedAt);
  return { camera: isOrthographic ? withoutPerspective(camera, lookedAt) : camera, target: lookedAt };
}

/** The least distance of a file camera's target, in radii of the model. */
const LEAST_DISTANCE = 0.16;

/** A camera of a file, in the world, as a view. Its target is the point on its line of sight nearest to the middle of the model. */
export function viewOfCamera({ position, forwards, up, high, isOrthographic, aspect = 0 }: FileCamera): LensView {
  const eye = new Vector3().fromArray(position);
  const way = new Vector3().fromArray(forwards);
  const target = eye.clone().addScaledVector(way, Math.max(LEAST_DISTANCE, -eye.dot(way)));
  return { position, target: target.toArray(), lens: { isOrthographic, high, aspect, up } };
}

/** A camera of a file, in the world. The sheet contains all of the file camera's own picture. @param aspect of the sheet */
export const cameraOfFile = (aspect: number, camera: FileCamera, isOrthographic: boolean): PlacedCamera =>
  cameraWithLens(aspect, viewOfCamera(camera), isOrthographic);

/** A view with a lens of its own. */
type LensView = CameraView & { lens: CameraLens };

function cameraWithLens(aspect: number, { position, target, lens }: LensView, isOrthographic: boolean): PlacedCamera {
  const half = halfHeightOf(lens, aspect);
  const camera = lens.isOrthographic
    ? new OrthographicCamera(-half * aspect, half * aspect, half, -half, LENS.near, 2 * FAR_AWAY)
    : new PerspectiveCamera(2 * MathUtils.radToDeg(Math.atan(half)), aspect, LENS.near, LENS.far);
  const lookedAt = new Vector3().fromArray(target);
  camera.position.fromArray(position);
  camera.up.fromArray(lens.up);
  camera.lookAt(lookedAt);
  const isChanged = isOrthographic && camera instanceof PerspectiveCamera;
  return { camera: isChanged ? withoutPerspective(camera, lookedAt) : camera, target: lookedAt };
}

/** An orthographic camera that shows the same part of the plane through the target. */
function withoutPerspective({ position, up, fov, aspect }: PerspectiveCamera, target: Vector3): OrthographicCamera {
  const toEye = position.clone().sub(target);
  const high = toEye.length() * Math.tan(MathUtils.degToRad(fov) / 2);
  const camera = new OrthographicCamera(-high * aspect, high * aspect, high, -high, LENS.near, 2 * FAR_AWAY);
  camera.up.copy(up);
  camera.position.copy(target).addScaledVector(toEye.normalize(), FAR_AWAY);
  camera.lookAt(target);
  return camera;
}

/** Turns a camera about the up axis through the model. @param angle in radians */
export function turnCamera({ camera, target }: PlacedCamera, angle: number): void {
  camera.position.applyAxisAngle(UP, angle);
  target.applyAxisAngle(UP, angle);
  camera.up.applyAxisAngle(UP, angle);
  camera.lookAt(target);
}

/**
 * The view of a framed model, shrunk as far as allowed to leave room for its shadow. A shadow that fits in this picture fits on the sheet
 * when the model is framed with it, without moving the model aside.
 *
 * @param framed a camera with the lens and aspect of the picture; it is changed
 */
export function roomiestView(
  framed: PerspectiveCamera,
  framedPoints: ArrayLike<number>,
  toEye: Vector3,
  { fill, part = [1, 1], room }: Framing & Required<Pick<Framing, 'room'>>,
): PerspectiveCamera {
  fitCamera(framed, framedPoints, toEye, { ...(fill !== undefined && { fill }), part, zoom: 1 / room.smaller });
  framed.updateMatrixWorld();
  const sheet = new Matrix4().makeScale(1 / (part[0] * room.shadow), 1 / (part[1] * room.shadow), 1);
  framed.projectionMatrix.premultiply(sheet);
  framed.projectionMatrixInverse.copy(framed.projectionMatrix).invert();
  return framed;
}
