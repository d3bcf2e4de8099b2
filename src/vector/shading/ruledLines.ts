/**
 * One family of lines, as in shaders/techniques/lines/ruledLines.glsl: level sets of a function at equal distances, whose width is the
 * tone. A fragment searches for lines near it; here the room of a given line is computed.
 */

import { FIELD_CONSTANTS, LINE_CONSTANTS } from '../../look/constants/lineConstants.js';

const { SPARSEST_SLOPE } = FIELD_CONSTANTS;
const { LEAST_OF_SMOOTH, MOST_OFF_TRIANGLE, PARTS_OF_TILE } = LINE_CONSTANTS;

const float = new Float64Array(1);
const words = new Uint32Array(float.buffer);
/** The index of the word with the exponent, by the machine's byte order. */
const HIGH = new Uint8Array(Float64Array.of(1).buffer)[7] !== 0 ? 1 : 0;

/** An approximate logarithm to base 2: exact at powers of two, linear between them. x: above 0. */
export function octaves(x: number): number {
  float[0] = x;
  const high = words[HIGH];
  const exponent = (high >>> 20) - 1023;
  // Subnormals; Infinity and NaN.
  if (exponent === -1023 || exponent >= 1024) return Math.log2(x);
  // The mantissa as a number from 1 to 2.
  words[HIGH] = (high & 0xfffff) | (1023 << 20);
  return exponent + float[0] - 1;
}

/** The inverse of `octaves`. */
export function powerOf2(octave: number): number {
  const whole = Math.floor(octave);
  return 2 ** whole * (1 + octave - whole);
}

/** The share of its steepest rise by which lines of the first family are spaced on the object. slope: its change along the surface. */
export const riseOf = (slope: number): number => Math.min(slope / SPARSEST_SLOPE, 1);

/** The spacing of lines. */
export interface LineSpacing {
  /** Pixels, or 256ths of a tile. */
  lineSpacing: number;
  /** Pixels. */
  minLineSpacing: number;
  /** 0: spaced on the object, 1: on the screen. */
  screenSpaceShare: number;
}

/**
 * The change of a function per pixel by which its lines are spaced: that of the smooth surface, within bounds of that on the flat triangle.
 *
 * @param smooth its change per pixel on the smooth surface
 * @param seen the same on the flat triangle
 */
export function spacedBy(smooth: number, seen: number): number {
  const shown = Math.max(seen, LEAST_OF_SMOOTH * smooth);
  return Math.min(Math.max(smooth, shown / MOST_OFF_TRIANGLE), shown * MOST_OFF_TRIANGLE);
}

/**
 * The octave of the spacing of lines at a place.
 *
 * @param rise of the function along the surface, per tile
 * @param perPixel its change from one pixel to the next
 * @param coarsest the octave of the widest spacing
 */
export function octaveOf(spacing: LineSpacing, rise: number, perPixel: number, coarsest: number): number {
  const { lineSpacing, minLineSpacing, screenSpaceShare } = spacing;
  const onObject = octaves((lineSpacing / PARTS_OF_TILE) * Math.max(rise, 1e-12));
  const onScreen = octaves(lineSpacing * perPixel);
  const wanted = onObject + screenSpaceShare * (onScreen - onObject);
  return Math.min(Math.max(wanted, octaves(minLineSpacing * perPixel)), coarsest);
}

/**
 * The room of a line, in units of the function. Old lines have as much as at exactly this spacing; new ones between them have the rest.
 *
 * @param rank the largest power of two that the value of the line is a multiple of, as an exponent
 */
export function roomOf(rank: number, octave: number): number {
  const top = Math.ceil(octave);
  if (rank >= top) return powerOf2(octave);
  return rank === top - 1 ? 2 ** top - powerOf2(octave) : 0;
}
