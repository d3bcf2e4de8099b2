import type { Hand, HandNumbers, HandStroke, SwatchTone } from 'three-hatching';
import { checkHand } from '../../strokes/hand/checkHand.js';

/** A hand whose text is longer than this is none for a link: some programs cut longer addresses off. */
export const LONGEST_HAND_LINK = 2000;

const VERSION = 1;
/** The steps of coordinates and widths, in millimetres: finer than a pen is held. */
const POINT_STEP = 0.05;
const WIDTH_STEP = 0.02;
/** Numbers are told in thousandths. */
const NUMBER_STEP = 0.001;
/** How far a stroke may lie from the points that are left of it, in millimetres, the finest first. */
const TOLERANCES = [0.03, 0.06, 0.12];
/** More than a text of the greatest length can hold. */
const MOST_STROKES = 1000;

const SWATCHES: readonly SwatchTone[] = ['light', 'middle', 'dark'];

/** The order in which numbers are written, which must not change within a version. */
const NUMBERS: readonly (keyof HandNumbers)[] = [
  ...(['length', 'lengthSpread', 'curvature', 'taperStart', 'taperEnd', 'width', 'widthSpread', 'wobble'] as const),
  ...(['angleSpread', 'spacing', 'spacingSpread', 'clustering', 'overlap', 'crossingAngle', 'crossingFrom'] as const),
];

/**
 * A hand as a short text of letters that may stand in a link: differences in steps of a twentieth of a millimetre, from point to point.
 * Points that a straight line stands for are left out, more of them where the text would be too long. Its name is left out.
 *
 * @returns undefined if it is longer than {@link LONGEST_HAND_LINK} all the same
 */
export function writeHand(hand: Hand): string | undefined {
  for (const tolerance of TOLERANCES) {
    const text = toText(bytesOf(hand, tolerance));
    if (text.length <= LONGEST_HAND_LINK) return text;
  }
  return undefined;
}

/** Reads what {@link writeHand} wrote. Undefined for anything else. */
export function readHand(text: string): Hand | undefined {
  if (text.length > LONGEST_HAND_LINK || !/^[\w-]+$/.test(text)) return undefined;
  const read = reader(fromText(text));
  if (read() !== VERSION) return undefined;
  const numbers = Object.fromEntries(NUMBERS.map((name) => [name, inSteps(signed(read()), NUMBER_STEP)]));
  const count = read();
  if (!(count > 0 && count <= MOST_STROKES)) return undefined;
  const strokes: HandStroke[] = [];
  const start = [0, 0];
  for (let i = 0; i < count; i++) {
    const head = read();
    const swatch = SWATCHES[head % 4];
    const length = Math.floor(head / 4);
    // A damaged text may ask for any number of points: no more are read than there are.
    if (!swatch || !(length >= 2 && length <= text.length)) return undefined;
    const points: number[] = [];
    const widths: number[] = [];
    let [x, y] = start;
    let width = 0;
    for (let k = 0; k < length; k++) {
      x += signed(read());
      y += signed(read());
      width += signed(read());
      if (k === 0) [start[0], start[1]] = [x, y];
      points.push(inSteps(x, POINT_STEP), inSteps(y, POINT_STEP));
      widths.push(inSteps(width, WIDTH_STEP));
    }
    strokes.push({ points, widths, swatch });
  }
  const hand: unknown = { version: 1, strokes, numbers };
  try {
    // Past the end, everything read is no number.
    checkHand('readHand', hand);
    return hand;
  } catch {
    return undefined;
  }
}

function bytesOf({ strokes, numbers }: Hand, tolerance: number): Uint8Array {
  const bytes: number[] = [];
  const write = (value: number): void => {
    let rest = value;
    for (; rest >= 128; rest = Math.floor(rest / 128)) bytes.push(128 + (rest % 128));
    bytes.push(rest);
  };
  write(VERSION);
  for (const name of NUMBERS) write(unsigned(Math.round(numbers[name] / NUMBER_STEP)));
  write(strokes.length);
  const start = [0, 0];
  for (const { points, widths, swatch = 'middle' } of strokes) {
    const kept = keptPoints(points, widths, tolerance);
    write(4 * kept.length + SWATCHES.indexOf(swatch));
    let [x, y] = start;
    let width = 0;
    kept.forEach((index, k) => {
      const nextX = Math.round(points[2 * index] / POINT_STEP);
      const nextY = Math.round(points[2 * index + 1] / POINT_STEP);
      // No stroke is invisible.
      const nextWidth = Math.max(1, Math.round(widths[index] / WIDTH_STEP));
      for (const step of [nextX - x, nextY - y, nextWidth - width]) write(unsigned(step));
      [x, y, width] = [nextX, nextY, nextWidth];
      if (k === 0) [start[0], start[1]] = [x, y];
    });
  }
  return Uint8Array.from(bytes);
}

/** The indices of the points that are left: every other one, and its width, lies within the tolerance of the line between two of them (Douglas and Peucker 1973). */
function keptPoints(points: readonly number[], widths: readonly number[], tolerance: number): number[] {
  const kept = new Set([0, widths.length - 1]);
  const spans: [number, number][] = [[0, widths.length - 1]];
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span;
    let farthest = tolerance;
    let at = -1;
    for (let i = from + 1; i < to; i++) {
      const away = distance(points, widths, i, from, to);
      if (away > farthest) [farthest, at] = [away, i];
    }
    if (at < 0) continue;
    kept.add(at);
    spans.push([from, at], [at, to]);
  }
  return [...kept].sort((a, b) => a - b);
}

/** How far a point, or its width, is from the line between two others. */
function distance(points: readonly number[], widths: readonly number[], i: number, from: number, to: number): number {
  const [x, y] = [points[2 * from], points[2 * from + 1]];
  const [dx, dy] = [points[2 * to] - x, points[2 * to + 1] - y];
  const [px, py] = [points[2 * i] - x, points[2 * i + 1] - y];
  const square = dx * dx + dy * dy;
  const share = square > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / square)) : 0;
  const width = widths[from] + share * (widths[to] - widths[from]);
  return Math.max(Math.hypot(px - share * dx, py - share * dy), Math.abs(widths[i] - width));
}

/** Whole numbers of either sign as such from 0, small ones small. */
const unsigned = (value: number): number => (value < 0 ? -2 * value - 1 : 2 * value);
const signed = (value: number): number => (value % 2 === 1 ? -(value + 1) / 2 : value / 2);

/** So that 3 × 0.05 is 0.15. */
const inSteps = (count: number, step: number): number => Math.round(count * step * 1000) / 1000;

/** Reads one whole number after the other; NaN past the end. */
function reader(bytes: Uint8Array): () => number {
  let at = 0;
  return () => {
    let value = 0;
    for (let factor = 1; factor < 2 ** 35; factor *= 128) {
      const byte = bytes[at++];
      if (byte === undefined) return Number.NaN;
      value += factor * (byte % 128);
      if (byte < 128) return value;
    }
    return Number.NaN;
  };
}

const toText = (bytes: Uint8Array): string =>
  btoa(String.fromCharCode(...bytes))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');

function fromText(text: string): Uint8Array {
  // A length that is 1 more than a multiple of 4 is none of this encoding.
  if (text.length % 4 === 1) return new Uint8Array();
  return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
}
