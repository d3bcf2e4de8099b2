import { acceptSetting, type SettingKey, type Settings } from './settings.js';

/**
 * The lens of a camera that differs from the page's. All of the picture that it frames is shown on any sheet. Numbers are of single
 * precision.
 */
export interface CameraLens {
  isOrthographic: boolean;
  /** Half the height of the picture: at distance 1, or at any distance if it is orthographic. */
  high: number;
  /** Width of the picture divided by its height; 0 if the file leaves it open. */
  aspect: number;
  /** The up direction of the picture. */
  up: [number, number, number];
}

/** Position and target of a camera, in units of the model's radius. Numbers are of single precision. */
export interface CameraView {
  position: [number, number, number];
  target: [number, number, number];
  /** Undefined for the page's own lens. */
  lens?: CameraLens | undefined;
}

/**
 * Half the height of a picture with the given aspect that contains all of a lens's own picture: at distance 1, or at any distance if it is
 * orthographic.
 */
export const halfHeightOf = ({ high, aspect: own }: CameraLens, aspect: number): number =>
  Math.max(high, (high * own) / aspect);

/** The maximum distance of a camera, in radii of the model; the page writes none farther away. */
const FARTHEST = 100;
/** The allowed range of half the height of a lens's picture, and of its aspect. */
const SIZES = { from: 1e-3, to: 1e3 } as const;

const KINDS: readonly string[] = ['perspective', 'orthographic'];
const [PLACE, LENS] = [6, 5];

/** A camera as parts of a text: six numbers for position and target, then the kind and the numbers of its own lens, if it has one. */
export function cameraParts({ position, target, lens }: CameraView): (string | number)[] {
  const place = [...position, ...target];
  return lens ? [...place, KINDS[Number(lens.isOrthographic)], lens.high, lens.aspect, ...lens.up] : place;
}

/**
 * Removes the parts written by {@link cameraParts} from the front, and returns their camera.
 *
 * @returns undefined if the parts are not a camera
 */
export function takeCamera(parts: string[]): CameraView | undefined {
  const [x, y, z, tx, ty, tz] = parts.splice(0, PLACE).map(readNumber);
  const view: CameraView = { position: [x, y, z], target: [tx, ty, tz] };
  const kind = KINDS.indexOf(parts[0]);
  if (kind !== -1) {
    parts.shift();
    const [high, aspect, upX, upY, upZ] = parts.splice(0, LENS).map(readNumber);
    view.lens = { isOrthographic: kind === 1, high, aspect, up: [upX, upY, upZ] };
  }
  return isCamera(view) ? view : undefined;
}

/** Whether the numbers of a camera are within the allowed ranges. */
export function isCamera({ position, target, lens }: CameraView): boolean {
  if (![...position, ...target].every((value) => Math.abs(value) <= FARTHEST)) return false;
  if (!lens) return true;
  const { high, aspect, up } = lens;
  const isSize = (value: number): boolean => value >= SIZES.from && value <= SIZES.to;
  return (
    isSize(high) && (aspect === 0 || isSize(aspect)) && up.every((value) => Math.abs(value) <= 1) && up.some(Boolean)
  );
}

/** Rounds a camera to single precision, as the page stores it. */
export const inSingle = ({ position, target, lens }: CameraView): CameraView => ({
  position: singles(position),
  target: singles(target),
  ...(lens && {
    lens: { ...lens, high: Math.fround(lens.high), aspect: Math.fround(lens.aspect), up: singles(lens.up) },
  }),
});

const singles = ([x, y, z]: readonly number[]): [number, number, number] => [
  Math.fround(x),
  Math.fround(y),
  Math.fround(z),
];

const readNumber = (text: string): number => (text.trim() === '' ? Number.NaN : Number(text));

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

/** The most characters of a name. */
const NAME_LENGTH = 40;

/** A user's name for something, in one line, without control characters, and shortened to the maximum length. */
export function plainName(text: string): string {
  const visible = text.replace(/[\p{Cc}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]+/gu, ' ').replace(/\s+/g, ' ');
  return [...visible.trim()].slice(0, NAME_LENGTH).join('').trim();
}
