import { Group, MathUtils, PerspectiveCamera, Scene, Spherical, Vector3 } from 'three';
import { bakeOcclusion, flatteringLight, type PresetName } from 'three-hatching';
import { runToEnd } from '../../mesh/phases.js';
import { lyingSize } from '../../vector/svg/sheetSizes.js';
import { bakeFurther } from '../../viewer/drawing/bakeFurther.js';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import { indexOfName } from '../../viewer/files/common/ModelError.js';
import { type FileCamera, movedExtras } from '../../viewer/files/common/ModelExtras.js';
import { Backdrop } from '../../viewer/sceneSetup/Backdrop.js';
import { ABOUT_SQUARE, proportionOf, strokeShare } from '../../viewer/sceneSetup/framing.js';
import { Ground } from '../../viewer/sceneSetup/Ground.js';
import { castersOf, WHOLE_SHEET } from '../../viewer/sceneSetup/groundShadow.js';
import { DEFAULT_VIEW, LENS } from '../../viewer/sceneSetup/LensCamera.js';
import { LightRig } from '../../viewer/sceneSetup/LightRig.js';
import { lightsOfFile } from '../../viewer/sceneSetup/ofFile.js';
import {
  cameraOfFile,
  type EyeDirection,
  eyeDirection,
  framedCamera,
  linkedCamera,
  type PlacedCamera,
  roomiestView,
} from '../../viewer/sceneSetup/placeCamera.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import { firstView, presetLook, wholeLook } from '../../viewer/settings/presets.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { formDrawn } from '../../viewer/settings/settingValues.js';
import { readLink } from '../../viewer/settings/shareLink.js';
import { cameraSights } from '../../viewer/views/cameraSights.js';
import { chooseViews } from '../../viewer/views/chooseViews.js';
import { sceneTriangles } from '../../viewer/views/sceneTriangles.js';
import type { DrawingOptions } from '../parseDrawing.js';

/** The settings and the camera of a drawing. */
interface DrawnWith {
  settings: Settings;
  /** The camera of a link; undefined to frame the model. */
  camera: CameraView | undefined;
  /** Whether an option or a link sets the light; if not, it is chosen for the view. */
  isLit: boolean;
}

/**
 * The playground settings for a command line: those of the link or of the first view, overridden by options.
 *
 * @param link the hash of a link
 * @param upAxis up axis of the model
 */
export function settingsFor(
  { preset, view, light, shadows, up }: DrawingOptions,
  link: string | undefined,
  upAxis: Settings['upAxis'],
): DrawnWith {
  const linked = link === undefined ? undefined : readLink(link);
  const settings: Settings = linked?.settings ?? firstView();
  // A preset brings the playground's shadows along, unless a link sets its own.
  if (preset) Object.assign(settings, linked ? presetLook(preset as PresetName) : wholeLook(preset as PresetName));
  if (light) {
    const azimuth = MathUtils.euclideanModulo(light.azimuth + 180, 360) - 180;
    Object.assign(settings, { lightAzimuth: azimuth, lightElevation: light.elevation, lightFollows: 'model' });
  }
  if (shadows !== undefined) settings.shadows = shadows ? 'on' : 'off';
  if (settings.shadows === 'off' && settings.ground === 'shadow') settings.ground = SETTINGS.ground.default;
  const isUpLinked = link !== undefined && new URLSearchParams(link).has('upAxis');
  Object.assign(settings, {
    model: 'file',
    compare: SETTINGS.compare.default,
    debugView: SETTINGS.debugView.default,
    upAxis: up ?? (isUpLinked ? settings.upAxis : upAxis),
  });
  return { settings, camera: view ? undefined : linked?.camera, isLit: light !== undefined || linked !== undefined };
}

/** How a model fills the sheet within its margins, and how it leaves room for its shadow. */
const ON_SHEET = { fill: 0.96, room: { model: 0.92, shadow: 0.93, smaller: 1.25 } } as const;
const MILLIMETRES_PER_INCH = 25.4;
const UP = new Vector3(0, 1, 0);

/** Reports the current step, and its progress in [0, 1]. */
type Report = (stage: string, progress: number) => void;

/** A model on its ground, with lights and a camera. */
export interface ReadyScene {
  scene: Scene;
  lights: LightRig;
  placed: PlacedCamera;
  /** Places the lights for the camera's present position, and fades the shadow on the ground before it reaches the edge of the sheet. */
  placeLights(): void;
  /** Size of the sheet in its orientation, millimetres. */
  sheet: readonly [width: number, height: number];
}

/**
 * Sets up the scene of a model as the playground does: upright, on its ground, with lights that suit the view and a camera that frames all
 * of it. Bakes form lines and occlusion where the settings ask for them.
 *
 * @param angles by which the camera is turned for its pictures, in radians; the model fits in all of them
 */
export async function setUpScene(
  model: HatchedModel,
  { settings, camera: place, isLit }: DrawnWith,
  options: DrawingOptions,
  angles: readonly number[],
  { signal, report }: { signal: AbortSignal; report: Report },
): Promise<ReadyScene> {
  const scene = new Scene();
  const lights = new LightRig(scene);
  // The order of the playground's scene, in which lines are found and joined: the same link then gives the same paths.
  const { ground, isMade } = groundIn(scene);
  const upright = new Group().add(model.root);
  upright.rotation.set(...lookOf(settings).upright);
  scene.add(upright);
  scene.updateMatrixWorld();
  const framedPoints = turnedPoints(model.framedPoints, upright);
  const inPicture = aroundUpright(framedPoints, angles);
  const { cameras, lights: fileLights } = movedExtras(model.extras, upright.matrixWorld);
  const seen = viewOf(options, place, cameras, () => automaticView(model, settings.upAxis, cameras, options));
  const fileCamera = 'name' in seen ? seen : undefined;
  const eye = 'name' in seen ? eyeOfFile(seen) : seen;
  const { toEye, up } = eye;
  const proportion = fileCamera?.aspect ?? proportionOf(inPicture, toEye, up);
  const sheet = lyingSize(options.sheet, proportion > ABOUT_SQUARE);
  const [width, height] = sheet.map((side) => side - 2 * options.margin);
  const aspect = width / height;
  const { orthographic: isOrthographic, zoom } = options;
  model.apply(lookOf(settings));
  const lit = !isLit && options.usesFileLights ? lightsOfFile(fileLights) : undefined;
  if (lit) Object.assign(settings, lit.settings);
  else if (!isLit) {
    const lens = new PerspectiveCamera(LENS.fieldOfView, aspect, LENS.near, LENS.far);
    lens.up.copy(up);
    const { direction } = flatteringLight(model.root, roomiestView(lens, framedPoints, toEye, ON_SHEET), {
      onGround: framedPoints,
    });
    const { theta, phi } = new Spherical().setFromVector3(direction);
    settings.lightAzimuth = MathUtils.radToDeg(theta);
    settings.lightElevation = 90 - MathUtils.radToDeg(phi);
  }
  const look = lookOf(settings);
  model.apply(look);
  lights.apply(look.lights);
  ground.extent = model.extent;
  ground.height = model.bounds.clone().applyMatrix4(upright.matrixWorld).min.y;
  ground.apply(look);
  if (look.ground !== 'none') await isMade;
  const backdrop = new Backdrop(scene);
  backdrop.apply(look, model.extent);
  const shadow = look.showsGround ? lights.shadowOf(framedPoints, ground.height, toEye, up) : undefined;
  const placed = fileCamera
    ? cameraOfFile(aspect, fileCamera, isOrthographic)
    : place
      ? linkedCamera(aspect, place, isOrthographic)
      : framedCamera(aspect, inPicture, eye, {
          ...ON_SHEET,
          isOrthographic,
          ...(shadow && { shadow: aroundUpright(shadow, angles) }),
        });
  placed.camera.zoom = zoom;
  placed.camera.updateProjectionMatrix();
  const casters = look.showsGround ? castersOf(model.root, model.motion) : [];
  const placeLights = (): void => {
    lights.place(placed.camera);
    ground.endShadows(look, lights.fadeOf(casters, ground.height, placed.camera, WHOLE_SHEET));
  };
  const pixels = options.dpi / MILLIMETRES_PER_INCH;
  const share = strokeShare(width * pixels, height * pixels);
  model.setWidths(look, share);
  ground.setWidths(look, share);
  backdrop.setWidths(look, share);
  await bake(model, settings, signal, report);
  return { scene, lights, placed, placeLights, sheet };
}

const namesOf = (named: readonly { name: string }[]): string[] => named.map(({ name }) => name);

/** The direction from what a camera of a file looks at to its eye. */
function eyeOfFile(fileCamera: FileCamera): EyeDirection {
  const { camera, target } = cameraOfFile(1, fileCamera, false);
  return { toEye: camera.position.clone().sub(target), up: camera.up };
}

/** The direction to the eye, or a camera of the file: of the options, or else of a link, or else an automatic one. */
function viewOf(
  { view, camera }: DrawingOptions,
  place: DrawnWith['camera'],
  cameras: readonly FileCamera[],
  automatic: () => EyeDirection | FileCamera,
): EyeDirection | FileCamera {
  if (camera !== undefined) return cameras[indexOfName(namesOf(cameras), camera)];
  if (view && 'azimuth' in view) return eyeDirection(view.azimuth, view.elevation);
  if (view || !place) return automatic();
  return { toEye: new Vector3(...place.position).sub(new Vector3(...place.target)), up: UP };
}

/**
 * One of the cameras of a file that see the model, then of the views that show it best, by rank; the last of them if there are fewer, and the
 * playground's default if it has no area.
 *
 * @param cameras of the upright model
 */
function automaticView(
  { root, extras, joinedParts }: HatchedModel,
  upAxis: Settings['upAxis'],
  cameras: readonly FileCamera[],
  { view }: DrawingOptions,
): EyeDirection | FileCamera {
  const triangles = sceneTriangles(root, joinedParts);
  const sights = cameraSights(triangles, extras.cameras);
  const seeing = cameras.filter((_, i) => sights[i] === 'model');
  const rank = view && 'rank' in view ? view.rank : 1;
  if (rank <= seeing.length) return seeing[rank - 1];
  const views = runToEnd(chooseViews(triangles, upAxis));
  const chosen = views[Math.min(rank - seeing.length, views.length) - 1];
  return chosen ? eyeDirection(chosen.azimuth, chosen.elevation) : { toEye: new Vector3(...DEFAULT_VIEW), up: UP };
}

/** A ground whose parts are made when a look first needs them. */
function groundIn(scene: Scene): { ground: Ground; isMade: Promise<void> } {
  let onReady = (): void => {};
  const isMade = new Promise<void>((resolve) => {
    onReady = resolve;
  });
  return { ground: new Ground(scene, onReady), isMade };
}

/** Bakes form lines and occlusion, if the settings ask for them. */
async function bake(
  model: HatchedModel,
  settings: DrawnWith['settings'],
  signal: AbortSignal,
  report: Report,
): Promise<void> {
  const form = formDrawn(settings);
  if (form) {
    const stage = 'laying lines along the form';
    const onProgress = (progress: number): void => report(stage, 0.6 * progress);
    const crossAngle = MathUtils.degToRad(settings.crossAngle);
    await bakeFurther(model.root, { form: { crossAngle, auto: form.auto } }, { signal, onProgress }, (former, made) => {
      if (made !== former) former.dispose();
    });
  }
  // Occlusion is stored per vertex, and instances share their vertices.
  if (settings.occlusion === 0 || meshesOf(model.root).every((mesh) => 'isInstancedMesh' in mesh)) return;
  const onProgress = (progress: number): void => report('darkening hollows', 0.6 + 0.4 * progress);
  await bakeOcclusion(model.root, { signal, onProgress });
}

/** Transforms points from the space of a group to the world. */
function turnedPoints(points: ArrayLike<number>, { matrixWorld }: Group): number[] {
  const point = new Vector3();
  const turned: number[] = [];
  for (let i = 0; i < points.length; i += 3) turned.push(...point.fromArray(points, i).applyMatrix4(matrixWorld));
  return turned;
}

/** The maximum number of points for placing a camera. */
const MANY_POINTS = 200_000;

/** Copies of the points as seen by cameras that are turned about the up axis: each turned by a negated angle. */
function aroundUpright(points: readonly number[], angles: readonly number[]): readonly number[] {
  if (angles.length === 1 && angles[0] === 0) return points;
  const step = 3 * Math.ceil((points.length / 3) * (angles.length / MANY_POINTS));
  const turned: number[] = [];
  const point = new Vector3();
  for (const angle of angles) {
    for (let i = 0; i < points.length; i += step) turned.push(...point.fromArray(points, i).applyAxisAngle(UP, -angle));
  }
  return turned;
}
