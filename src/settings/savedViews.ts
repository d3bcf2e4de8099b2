import { acceptSetting } from './acceptSetting.js';
import type { CameraView } from './CameraView.js';
import { plainName } from './plainName.js';
import type { SettingKey, Settings } from './settings.js';

/** Where the lights are, and which there are. */
const LIGHT_KEYS = [
  'lightKind',
  'lightFollows',
  'lightAzimuth',
  'lightElevation',
  'lightDistance',
  'spotAngle',
  'secondLight',
  'secondAzimuth',
  'secondElevation',
] as const satisfies readonly SettingKey[];

/** A view of a drawing that was kept to return to. */
export interface SavedView {
  name: string;
  /** Undefined if the model was framed. */
  camera: CameraView | undefined;
  light: Pick<Settings, (typeof LIGHT_KEYS)[number]>;
}

/** So many views are kept with a drawing: one for each digit. */
export const MAX_VIEWS = 9;

/** A camera further away than this, in radii of the model, is none of ours. */
const FARTHEST = 100;

export function lightOf(settings: Settings): SavedView['light'] {
  return Object.fromEntries(LIGHT_KEYS.map((key) => [key, settings[key]])) as SavedView['light'];
}

export const isLitBy = (settings: Settings, light: SavedView['light']): boolean =>
  LIGHT_KEYS.every((key) => settings[key] === light[key]);

/** A view as text of a link: six numbers of its camera, or `framed`; its light; its name. */
export function writeView({ camera, light, name }: SavedView): string {
  // To the last digit, so that the strokes are those of the view.
  const numbers = camera ? [...camera.position, ...camera.target] : ['framed'];
  return [...numbers, ...LIGHT_KEYS.map((key) => light[key]), name].join('_');
}

/** Reads what {@link writeView} wrote. Undefined for anything else. */
export function readView(text: string): SavedView | undefined {
  const parts = text.split('_');
  const numbers = parts[0] === 'framed' ? undefined : parts.splice(0, 6).map(readNumber);
  if (!numbers) parts.shift();
  const values = LIGHT_KEYS.map((key) => acceptSetting(key, parts.shift() ?? ''));
  const name = plainName(parts.join('_'));
  if (!name || values.includes(undefined)) return undefined;
  if (numbers && !isCamera(numbers)) return undefined;
  const light = Object.fromEntries(LIGHT_KEYS.map((key, i) => [key, values[i]])) as SavedView['light'];
  return { name, camera: numbers && cameraOf(numbers), light };
}

const readNumber = (text: string): number => (text === '' ? Number.NaN : Number(text));

type CameraNumbers = [number, number, number, number, number, number];

/** Whether numbers are the position and the target of a camera. */
export function isCamera(numbers: readonly number[]): numbers is CameraNumbers {
  return numbers.length === 6 && numbers.every((value) => Number.isFinite(value) && Math.abs(value) <= FARTHEST);
}

export const cameraOf = ([x, y, z, tx, ty, tz]: Readonly<CameraNumbers>): CameraView => ({
  position: [x, y, z],
  target: [tx, ty, tz],
});
