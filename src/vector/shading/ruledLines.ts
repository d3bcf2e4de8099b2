/**
 * One family of lines, as shaders/techniques/engraved/ruledLines.glsl has it: level sets of a function at equal distances, whose width is
 * the tone. A fragment asks which lines are near; here a line asks how much room it has.
 */

import { FIELD_CONSTANTS, LINE_CONSTANTS } from '../../look/constants/engravedConstants.js';

const { SPARSEST_SLOPE } = FIELD_CONSTANTS;
const { LEAST_OF_SMOOTH, MOST_OFF_TRIANGLE, PARTS_OF_TILE } = LINE_CONSTANTS;

const float = new Float64Array(1);
const words = new Uint32Array(float.buffer);
/** The word with the exponent, where the machine stores it. */
const HIGH = new Uint8Array(Float64Array.of(1).buffer)[7] !== 0 ? 1 : 0;

/** The logarithm to base 2 at powers of two, and linear between them. x: above 0. */
export function octaves(x: number): number {
  float[0] = x;
  const high = words[HIGH];
  const exponent = (high >>> 20) - 1023;
  // Below are numbers that are stored without all their digits, and beyond what is none.
  if (exponent === -1023 || exponent >= 1024) return Math.log2(x);
  // The same digits, from 1 to 2.
  words[HIGH] = (high & 0xfffff) | (1023 << 20);
  return exponent + float[0] - 1;
}

/** The inverse. */
export function powerOf2(octave: number): number {
  const whole = Math.floor(octave);
  return 2 ** whole * (1 + octave - whole);
}

/** The share of its steepest rise by which lines of the first family are spaced on the object. slope: its change along the surface. */
export const riseOf = (slope: number): number => Math.min(slope / SPARSEST_SLOPE, 1);

/** How far apart lines are asked to be. */
export interface LineSpacing {
  /** Pixels, or 256ths of a tile. */
  lineSpacing: number;
  /** Pixels. */
  finestSpacing: number;
  /** 0: spaced on the object, 1: on the screen. */
  sizedOnScreen: number;
}

/**
 * By how much a function changes per pixel where its lines are spaced: as the smooth normal has it, within bounds of what the flat triangle shows.
 *
 * @param smooth its change per pixel by the smooth normal
 * @param seen the same on the flat triangle
 */
export function spacedBy(smooth: number, seen: number): number {
  const shown = Math.max(seen, LEAST_OF_SMOOTH * smooth);
  return Math.min(Math.max(smooth, shown / MOST_OFF_TRIANGLE), shown * MOST_OFF_TRIANGLE);
}

/**
 * The octave of the distance between lines at a place.
 *
 * @param rise of the function along the surface, per tile
 * @param perPixel its change from one pixel to the next
 * @param coarsest the octave of the lines that lie farthest apart
 */
export function octaveOf(spacing: LineSpacing, rise: number, perPixel: number, coarsest: number): number {
  const { lineSpacing, finestSpacing, sizedOnScreen } = spacing;
  const onObject = octaves((lineSpacing / PARTS_OF_TILE) * Math.max(rise, 1e-12));
  const onScreen = octaves(lineSpacing * perPixel);
  const wanted = onObject + sizedOnScreen * (onScreen - onObject);
  return Math.min(Math.max(wanted, octaves(finestSpacing * perPixel)), coarsest);
}

/**
 * The room that a line has, in units of the function. Old lines have as much as they would at just this spacing; those that are born between
 * them have what is left.
 *
 * @param rank the largest power of two that the value of the line is a multiple of, as an exponent
 */
export function roomOf(rank: number, octave: number): number {
  const top = Math.ceil(octave);
  if (rank >= top) return powerOf2(octave);
  return rank === top - 1 ? 2 ** top - powerOf2(octave) : 0;
}
