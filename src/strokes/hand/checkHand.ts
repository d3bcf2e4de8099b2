import { checkHandNumbers, checkIsObject, type Hand, type HandStroke, type SwatchTone } from './Hand.js';

/**
 * Checks that a value, such as one read from JSON, is a hand.
 *
 * @param caller the function named in the error
 * @throws TypeError or RangeError with the fault
 */
export function checkHand(caller: string, hand: unknown): asserts hand is Hand {
  checkIsObject(caller, hand);
  const { version, name, strokes, mirror } = hand as Partial<Hand>;
  if (version !== 1) throw new RangeError(`${caller}: hand.version is ${String(version)}, but must be 1.`);
  if (name !== undefined && typeof name !== 'string') {
    throw new TypeError(`${caller}: hand.name is ${String(name)}, but must be a text, or left out.`);
  }
  if (mirror !== undefined && typeof mirror !== 'boolean') {
    throw new TypeError(`${caller}: hand.mirror is ${String(mirror)}, but must be true or false, or left out.`);
  }
  checkStrokes(`${caller}: hand`, strokes);
  checkHandNumbers(caller, hand);
}

/** The largest number of points of all strokes together. */
export const MAX_POINTS = 100_000;

/** The largest coordinate and width, in millimetres: far more than any sheet, and far below overflow. */
const MAX_MILLIMETRES = 10_000;

const SWATCHES: readonly SwatchTone[] = ['light', 'middle', 'dark'];

/**
 * Checks that values are strokes drawn by a person.
 *
 * @param caller the function named in the error
 * @throws TypeError for a wrong type; RangeError for no strokes, too many points, or a number out of range
 */
export function checkStrokes(caller: string, strokes: unknown): asserts strokes is readonly HandStroke[] {
  if (!Array.isArray(strokes)) {
    throw new TypeError(`${caller}: the strokes are ${kindOf(strokes)}, but must be an array of { points, widths }.`);
  }
  if (strokes.length === 0) throw new RangeError(`${caller}: there are no strokes; draw at least one.`);
  let points = 0;
  for (const [index, stroke] of strokes.entries()) {
    checkStroke(`${caller}: strokes[${index}]`, stroke);
    points += stroke.widths.length;
    if (points > MAX_POINTS) {
      throw new RangeError(`${caller}: the strokes have more than ${MAX_POINTS} points; give fewer strokes or points.`);
    }
  }
}

function checkStroke(name: string, stroke: Partial<HandStroke> | null): asserts stroke is HandStroke {
  if (typeof stroke !== 'object' || stroke === null) {
    throw new TypeError(`${name} is ${String(stroke)}, but must be { points, widths }.`);
  }
  const { points, widths, swatch } = stroke;
  if (!isList(points)) throw new TypeError(`${name}.points is ${kindOf(points)}, but must be an array of numbers.`);
  if (!isList(widths)) throw new TypeError(`${name}.widths is ${kindOf(widths)}, but must be an array of numbers.`);
  if (widths.length * 2 !== points.length) {
    throw new RangeError(
      `${name} has ${points.length} coordinates and ${widths.length} widths, but needs x, y and a width for every point.`,
    );
  }
  // Checked first, to avoid a loop over millions of numbers.
  if (widths.length > MAX_POINTS) {
    throw new RangeError(`${name} has ${widths.length} points, but all strokes together may have ${MAX_POINTS}.`);
  }
  if (widths.length < 2) throw new RangeError(`${name} has ${widths.length} points, but a stroke needs two or more.`);
  for (let i = 0; i < points.length; i++) {
    // JSON stores NaN as null, which would count as 0.
    if (typeof points[i] !== 'number' || !(Math.abs(points[i]) <= MAX_MILLIMETRES)) {
      throw new RangeError(
        `${name}.points[${i}] is ${String(points[i])}, but must be a number from −${MAX_MILLIMETRES} to ${MAX_MILLIMETRES} mm.`,
      );
    }
  }
  for (let i = 0; i < widths.length; i++) {
    if (!(widths[i] > 0 && widths[i] <= MAX_MILLIMETRES)) {
      throw new RangeError(
        `${name}.widths[${i}] is ${String(widths[i])}, but must be a width above 0 mm and up to ${MAX_MILLIMETRES} mm.`,
      );
    }
  }
  if (swatch !== undefined && !SWATCHES.includes(swatch)) {
    throw new RangeError(
      `${name}.swatch is ${String(swatch)}, but must be one of ${SWATCHES.join(', ')}, or left out.`,
    );
  }
}

/** Whether a value is an array or typed array; programs that record a pen may use either. */
const isList = (value: unknown): value is readonly number[] =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

const kindOf = (value: unknown): string => (typeof value === 'object' && value !== null ? 'an object' : String(value));
