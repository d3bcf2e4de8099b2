/** The unsteadiness of a hand, as shaders/techniques/engraved/hand.glsl has it. It belongs to the place on the object. */
import type { Vec3 } from './vectors.js';

/** Units of the slow waves of a hand to a tile. */
const HAND_WAVES = 3.5;
/** How far lines stray, in tiles. */
const STRAY = 0.012;
/** How much the pressure of a hand changes at most, and how much the widths of lines differ. */
const PRESSURE = 0.3;
const WIDTHS = 0.5;

/** A wave of period 2 within [−1, 1], made of two parabolas. */
function wave(x: number): number {
  const half = 0.5 * x;
  const t = 2 * (half - Math.floor(half)) - 1;
  return 4 * t * (Math.abs(t) - 1);
}

/** Three slow waves at a place in field space, each within [−1, 1]. */
export function slowWaves([px, py, pz]: Vec3): Vec3 {
  const [x, y, z] = [HAND_WAVES * px, HAND_WAVES * py, HAND_WAVES * pz];
  const bentX = x + 0.7 * wave(0.54 * y + 0.1);
  const bentY = y + 0.7 * wave(0.54 * z + 0.67);
  const bentZ = z + 0.7 * wave(0.54 * x + 1.4);
  return [wave(0.73 * bentZ + 0.35), wave(0.73 * bentX + 1.18), wave(0.73 * bentY + 1.66)];
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

/** A random number in [0, 1) that belongs to a line. line: its value, a multiple of a power of two. */
export function lotOf(line: number): number {
  float[0] = line;
  return (Math.imul(bits[0], 0x9e3779b9) >>> 8) / 16777216;
}

/** A factor on the width of a line, the same all along it; 1 in the mean. */
export const handWidth = (line: number, handmade: number): number =>
  1 + handmade * (WIDTHS * lotOf(line) - 0.5 * WIDTHS);
