/** The unsteadiness of a hand, as shaders/techniques/engraved/hand.glsl has it. It belongs to the place on the object. */
import { HAND_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { HASH_FACTORS } from '../../look/constants/patternConstants.js';
import type { Vec3 } from '../../look/vectors.js';

const { HAND_WAVES, BENT_BY, BENDS, BEND_PHASES, SLOW_WAVES, WAVE_PHASES, STRAY, PRESSURE, WIDTHS } = HAND_CONSTANTS;

/** A wave of period 2 within [−1, 1], made of two parabolas. */
function wave(x: number): number {
  const half = 0.5 * x;
  const t = 2 * (half - Math.floor(half)) - 1;
  return 4 * t * (Math.abs(t) - 1);
}

/** Three slow waves at a place in field space, each within [−1, 1]. */
export function slowWaves([px, py, pz]: Vec3): Vec3 {
  const [x, y, z] = [HAND_WAVES * px, HAND_WAVES * py, HAND_WAVES * pz];
  const bentX = x + BENT_BY * wave(BENDS * y + BEND_PHASES[0]);
  const bentY = y + BENT_BY * wave(BENDS * z + BEND_PHASES[1]);
  const bentZ = z + BENT_BY * wave(BENDS * x + BEND_PHASES[2]);
  return [
    wave(SLOW_WAVES * bentZ + WAVE_PHASES[0]),
    wave(SLOW_WAVES * bentX + WAVE_PHASES[1]),
    wave(SLOW_WAVES * bentY + WAVE_PHASES[2]),
  ];
}

/** Where the hand puts what belongs to a point, both in tiles. handmade: from 0, a ruling machine, to 1. */
export function handPoint([x, y, z]: Vec3, waves: Vec3, handmade: number): Vec3 {
  const stray = handmade * STRAY;
  return [x + stray * waves[0], y + stray * waves[1], z + stray * waves[2]];
}

/** Pressure comes and goes along a line: within [−0.3, 0.3]. */
export const handPressure = (waves: Vec3, handmade: number): number => handmade * PRESSURE * waves[0] * waves[1];

/** The tone that a pressure makes of a tone. Blank stays blank, and solid solid. */
export const handTone = (pressure: number, tone: number): number => tone + pressure * tone * (1 - tone);

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** The bits of a number in single precision, as a word. */
export function bitsOf(value: number): number {
  float[0] = value;
  return bits[0];
}

/**
 * A number in [0, 1) that belongs to a line. line: its value, a multiple of a power of two.
 *
 * The value is multiplied by a number whose binary digits repeat those that are given on both sides of its point, and the fraction is the hash.
 */
function hashBy(digits: number, line: number): number {
  const word = bitsOf(line);
  const exponent = (word >>> 23) & 31;
  const factor = (digits << exponent) | (digits >>> (-exponent & 31));
  const spread = Math.imul((word & 0x7fffff) | 0x800000, factor) ^ (word & 0x80000000);
  return (spread >>> 8) / 16777216;
}

/** One that is far from those of its neighbours: at any power of two they are at least 0.17 apart, and so is the next but one. */
export const hash01 = (line: number): number => hashBy(HASH_FACTORS.THUE_MORSE, line);

/** One by which three neighbours take turns: 0, a third and two thirds. */
export const turnOf = (line: number): number => (line === 0 ? 0 : hashBy(HASH_FACTORS.ONE_THIRD, line));

/** A factor on the width of a line, the same all along it; 1 in the mean. */
export const handWidth = (line: number, handmade: number): number =>
  1 + handmade * (WIDTHS * hash01(line) - 0.5 * WIDTHS);
