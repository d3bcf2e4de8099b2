import { acceptSetting } from './acceptSetting.js';
import type { CameraView } from './CameraView.js';
import { cameraParts, takeCamera } from './cameraNumbers.js';
import type { SettingKey, Settings } from './settings.js';

/** The settings of kind and position of the lights. */
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

/** A saved view of a drawing. */
export interface SavedView {
  name: string;
  /** Undefined if the model was framed. */
  camera: CameraView | undefined;
  light: Pick<Settings, (typeof LIGHT_KEYS)[number]>;
}

/** The maximum number of saved views: one per digit key. */
export const MAX_VIEWS = 9;

export function lightOf(settings: Settings): SavedView['light'] {
  return Object.fromEntries(LIGHT_KEYS.map((key) => [key, settings[key]])) as SavedView['light'];
}

export const isLitBy = (settings: Settings, light: SavedView['light']): boolean =>
  LIGHT_KEYS.every((key) => settings[key] === light[key]);

/** A view as text for a link: camera numbers or `framed`, then the light, then the name. */
export function writeView({ camera, light, name }: SavedView): string {
  // Full precision, so that the strokes are exactly those of the view.
  const numbers = camera ? cameraParts(camera) : ['framed'];
  return [...numbers, ...LIGHT_KEYS.map((key) => light[key]), name].join('_');
}

/** Reads the text of {@link writeView}. Undefined for anything else. */
export function readView(text: string): SavedView | undefined {
  const parts = text.split('_');
  const isFramed = parts[0] === 'framed';
  if (isFramed) parts.shift();
  const camera = isFramed ? undefined : takeCamera(parts);
  const values = LIGHT_KEYS.map((key) => acceptSetting(key, parts.shift() ?? ''));
  const name = plainName(parts.join('_'));
  if (!name || values.includes(undefined)) return undefined;
  if (!isFramed && !camera) return undefined;
  const light = Object.fromEntries(LIGHT_KEYS.map((key, i) => [key, values[i]])) as SavedView['light'];
  return { name, camera, light };
}

const MOST = 40;

/** A user's name for something, in one line, without control characters, and shortened to the maximum length. */
export function plainName(text: string): string {
  const visible = text.replace(/[\p{Cc}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]+/gu, ' ').replace(/\s+/g, ' ');
  return [...visible.trim()].slice(0, MOST).join('').trim();
}
