import { type Camera, Matrix4, type Object3D, Vector3 } from 'three';
import { checkNames } from '../../worker/TaskOptions.js';
import { assertTree } from '../assertTree.js';
import { chooseLight } from './chooseLight.js';
import { OuterPoints, readTriangles } from './readTriangles.js';
import { seenSurface } from './seenSurface.js';

/** A light that suits a view of an object. */
export interface FlatteringLight {
  /** The direction to the light in world space, of length 1: the position of a `DirectionalLight` whose target is at the origin. */
  direction: Vector3;
  /** The share of the visible surface that lies in shade under this light, from 0 to 1; 0 if nothing is seen. */
  shade: number;
}

export interface FlatteringLightOptions {
  /**
   * Whether the object stands on level ground, through its lowest point. Its shadow there then lies wholly on the sheet, if a light in
   * front allows it; for that the light may be higher, or come from another side. For an object that moves, pass points instead, as xyz
   * in world space, which tell how far it reaches in all its poses. Default: false.
   */
  onGround?: boolean | ArrayLike<number>;
}

const OWN_OPTIONS = { onGround: true } satisfies Record<keyof FlatteringLightOptions, true>;

/**
 * Finds a light that shows an object well in a view: three-quarter from the front, from the upper left or right, so that about two
 * fifths of the visible surface lie in shade. A surface is in shade if it looks less than half as bright as one that faces the light;
 * occlusion that `bakeOcclusion` has baked counts, cast shadows do not.
 *
 * - The light is never behind the object, and at least 20° above the horizon of `camera.up`, unless the view is from so far below that no
 * light in front is.
 * - Visible meshes at or below the object count, in their present pose, as far as they are on the sheet. Leave out the ground. Batches
 * and triangles that reach behind the eye do not count.
 * - The same view gives the same light. A scene that is moved, turned about `camera.up` or scaled with its camera gets the same too.
 * Nothing is changed, drawn or read from the graphics card.
 * - It takes some milliseconds for a scene of any size: of more than 30,000 triangles only some are read, and at most 2,000 meshes
 * and 256 instances of each.
 *
 * @param object the object to light
 * @param camera the view, with its projection up to date
 * @throws TypeError for anything else than an object and a camera, and for an option that does not exist
 * @throws Error if the object is its own descendant
 */
export function flatteringLight(
  object: Object3D,
  camera: Camera,
  options: FlatteringLightOptions = {},
): FlatteringLight {
  if (!object?.isObject3D)
    throw new TypeError('flatteringLight: expected a THREE.Object3D, such as a scene or a mesh.');
  if (!camera?.isCamera) throw new TypeError('flatteringLight: expected a THREE.Camera as the second argument.');
  checkNames('flatteringLight', 'options', options, OWN_OPTIONS);
  const { onGround = false } = options;
  assertTree('flatteringLight', object);
  object.updateWorldMatrix(true, false);
  object.updateMatrixWorld();
  camera.updateWorldMatrix(true, false);
  const [right, up, toEye] = [0, 1, 2].map((axis) =>
    new Vector3().setFromMatrixColumn(camera.matrixWorld, axis).normalize().toArray(),
  );
  const top = camera.up.clone().normalize().toArray();
  const outer = new OuterPoints();
  if (typeof onGround === 'object') outer.addAll(onGround);
  const surface = seenSurface(readTriangles(object, camera, onGround === true ? outer : undefined));
  const toSheet = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const standing = onGround ? { points: outer.xyz, top, toSheet } : undefined;
  const { direction, shade } = chooseLight(surface, { right, up, toEye, top }, standing);
  return { direction: new Vector3(...direction), shade };
}
