import type { CameraView } from './CameraView.js';

/** The maximum distance of a camera, in radii of the model; the page writes none farther away. */
const FARTHEST = 100;
/** The allowed range of half the height of a lens's picture, and of its aspect. */
const [LEAST, MOST] = [1e-3, 1e3];

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
  const isSize = (value: number): boolean => value >= LEAST && value <= MOST;
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
