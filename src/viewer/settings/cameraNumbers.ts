import type { CameraView } from './CameraView.js';

/** A camera further away than this, in radii of the model, is none of ours. */
const FARTHEST = 100;
/** Half the height of a picture that a lens shows is in this range, and so is its proportion. */
const [LEAST, MOST] = [1e-3, 1e3];

const KINDS: readonly string[] = ['perspective', 'orthographic'];
const [PLACE, LENS] = [6, 5];

/** A camera as parts of a text: six numbers of its place, and those of its lens after its kind, if it has one of its own. */
export function cameraParts({ position, target, lens }: CameraView): (string | number)[] {
  const place = [...position, ...target];
  return lens ? [...place, KINDS[Number(lens.isOrthographic)], lens.high, lens.aspect, ...lens.up] : place;
}

/** Takes a camera from the begin of what {@link cameraParts} wrote, and leaves the rest. @returns undefined for anything else */
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

/** Whether a camera is one that a link may ask for. */
export function isCamera({ position, target, lens }: CameraView): boolean {
  if (![...position, ...target].every((value) => Math.abs(value) <= FARTHEST)) return false;
  if (!lens) return true;
  const { high, aspect, up } = lens;
  const isSize = (value: number): boolean => value >= LEAST && value <= MOST;
  return (
    isSize(high) && (aspect === 0 || isSize(aspect)) && up.every((value) => Math.abs(value) <= 1) && up.some(Boolean)
  );
}

/** A camera in single precision, as the page has it. */
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
