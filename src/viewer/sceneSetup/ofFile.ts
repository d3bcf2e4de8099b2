import { MathUtils, Spherical, Vector3 } from 'three';
import type { FileCamera, FileLight } from '../files/common/ModelExtras.js';
import { type CameraView, inSingle, isCamera, MAX_VIEWS, plainName, type SavedView } from '../settings/CameraView.js';
import { acceptSetting, SETTINGS, type SettingKey, type Settings } from '../settings/settings.js';
import { viewOfCamera } from './placeCamera.js';

/** Lights that send less than this share of the brightest light's are left out. */
const LEAST_SHARE = 0.05;
/** The number of lights drawn: the main light and a second sun. */
const MOST_LIGHTS = 2;

type LightSettings = Pick<
  Settings,
  | 'lightKind'
  | 'lightAzimuth'
  | 'lightElevation'
  | 'lightFollows'
  | 'lightDistance'
  | 'spotAngle'
  | 'secondLight'
  | 'secondAzimuth'
  | 'secondElevation'
  | 'secondStrength'
>;

/**
 * The brightest lights of a file as settings: the main light, and the next brightest as a second sun. Brightness is compared at the origin,
 * the centre of the model of radius 1.
 *
 * @param lights in the world
 * @returns undefined settings if no light reaches the model; and how many lights are left out
 */
export function lightsOfFile(lights: readonly FileLight[]): { settings: LightSettings; leftOut: number } | undefined {
  const [first, second] = [...lights].map(arriving).sort((a, b) => b.light - a.light);
  if (!first || !(first.light > 0)) return undefined;
  const hasSecond = second !== undefined && second.light > LEAST_SHARE * first.light;
  const main = placeOf(first.towards);
  const beside = hasSecond ? placeOf(second.towards) : undefined;
  const strength = hasSecond ? (100 * second.light) / first.light : undefined;
  const settings = {
    lightKind: first.kind,
    lightAzimuth: accepted('lightAzimuth', main.azimuth),
    lightElevation: accepted('lightElevation', main.elevation),
    lightFollows: 'model',
    lightDistance: accepted('lightDistance', first.distance),
    spotAngle: accepted('spotAngle', MathUtils.radToDeg(2 * first.angle)),
    secondLight: hasSecond ? 'free' : 'none',
    secondAzimuth: accepted('secondAzimuth', beside?.azimuth),
    secondElevation: accepted('secondElevation', beside?.elevation),
    secondStrength: accepted('secondStrength', strength),
  } as LightSettings;
  return { settings, leftOut: Math.max(0, lights.length - (hasSecond ? MOST_LIGHTS : 1)) };
}

/** The light that arrives at the middle of the model, and its direction. */
function arriving({ kind, intensity, position, forwards, angle }: FileLight): {
  kind: FileLight['kind'];
  light: number;
  towards: Vector3;
  distance: number;
  angle: number;
} {
  const way = new Vector3().fromArray(forwards);
  if (kind === 'directional') return { kind, light: intensity, towards: way.negate(), distance: 1, angle };
  const towards = new Vector3().fromArray(position);
  const distance = towards.length();
  // A lamp in the middle of the model has no direction.
  const light = distance > 0 ? intensity / distance ** 2 : 0;
  const isAside = kind === 'spot' && way.dot(towards) > -distance * Math.cos(angle);
  return { kind, light: isAside ? 0 : light, towards, distance, angle };
}

function placeOf(towards: Vector3): { azimuth: number; elevation: number } {
  const { theta, phi } = new Spherical().setFromVector3(towards);
  return { azimuth: MathUtils.radToDeg(theta), elevation: 90 - MathUtils.radToDeg(phi) };
}

/** The nearest allowed value of a setting; the default for undefined. */
const accepted = (key: SettingKey, value: number | undefined): string | number | undefined =>
  acceptSetting(key, value ?? SETTINGS[key].default);

type Light = SavedView['light'];

/**
 * Views of a file: one per camera and, if it has lights, one with these and one with the light found for the view.
 *
 * @param cameras in the world, where the model of radius 1 lies around the origin
 * @param light at present
 * @param found the light chosen for the view, if it differs from the file's
 * @returns at most {@link MAX_VIEWS} views, and the number of cameras left out
 */
export function viewsOfFile(
  cameras: readonly FileCamera[],
  light: Light,
  found: Light | undefined,
): { views: SavedView[]; leftOut: number } {
  const lit: SavedView[] = found
    ? [
        { name: 'Lights of the file', camera: undefined, light },
        { name: 'Light for the view', camera: undefined, light: found },
      ]
    : [];
  const seen = cameras.flatMap((camera, i): SavedView[] => {
    const view = cameraViewOf(camera);
    return view ? [{ name: plainName(camera.name) || `Camera ${i + 1}`, camera: view, light }] : [];
  });
  const views = [...lit, ...seen].slice(0, MAX_VIEWS);
  return { views, leftOut: lit.length + cameras.length - views.length };
}

/** A view through a file camera's lens; undefined if the camera is too far away. */
function cameraViewOf(camera: FileCamera): CameraView | undefined {
  const view = inSingle(viewOfCamera(camera));
  return isCamera(view) ? view : undefined;
}
