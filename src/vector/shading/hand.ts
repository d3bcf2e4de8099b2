/** The unsteadiness of a hand, fixed to the object, as in shaders/techniques/lines/hand.glsl. */
import { HAND_CONSTANTS } from '../../look/constants/lineConstants.js';
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

/** A point, displaced by the hand, tiles. irregularity: from 0, lines as by a ruling machine, to 1. */
export function handPoint([x, y, z]: Vec3, waves: Vec3, irregularity: number): Vec3 {
  const stray = irregularity * STRAY;
  return [x + stray * waves[0], y + stray * waves[1], z + stray * waves[2]];
}

/** Pressure varies along a line, within [−0.3, 0.3]. */
export const handPressure = (waves: Vec3, irregularity: number): number =>
  irregularity * PRESSURE * waves[0] * waves[1];

/** A tone, changed by a pressure. Blank stays blank, and solid solid. */
export const handTone = (pressure: number, tone: number): number => tone + pressure * tone * (1 - tone);

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** The bits of a number in single precision, as a word. */
export function bitsOf(value: number): number {
  float[0] = value;
  return bits[0];
}

/**
 * A hash of a line in [0, 1). line: its value, a multiple of a power of two.
 *
 * The value is multiplied by a number whose binary digits repeat the given ones on both sides of the point, and the fraction is the hash.
 */
function hashBy(digits: number, line: number): number {
  const word = bitsOf(line);
  const exponent = (word >>> 23) & 31;
  const factor = (digits << exponent) | (digits >>> (-exponent & 31));
  const spread = Math.imul((word & 0x7fffff) | 0x800000, factor) ^ (word & 0x80000000);
  return (spread >>> 8) / 16777216;
}

/** A hash of a line, at least 0.17 from those of its neighbours and of the next but one, at any power of two. */
export const hash01 = (line: number): number => hashBy(HASH_FACTORS.THUE_MORSE, line);

/** A hash of a line that is 0, a third or two thirds for three neighbours. */
export const turnOf = (line: number): number => (line === 0 ? 0 : hashBy(HASH_FACTORS.ONE_THIRD, line));

/** A factor on the width of a whole line; 1 in the mean. */
export const handWidth = (line: number, irregularity: number): number =>
  1 + irregularity * (WIDTHS * hash01(line) - 0.5 * WIDTHS);
