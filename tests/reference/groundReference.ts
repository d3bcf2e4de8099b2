/** A ground that shows shadows alone, in double precision, as documented. It shares no code with the shader. */
import { lotOf } from './engravedStrokes.js';
import type { Vec3 } from './referenceAdjacency.js';
import { clamp01, cross, unit } from './vectors.js';

/**
 * The tone of a shadow. A millionth of light counts as arriving anyway, so that there is no shadow where there is no light.
 *
 * @param arriving radiance, and `taken`, what shadows have taken of it
 * @param toneAt the tone that a share of the light prints, which is `blank` for all of it
 * @param shadowTone of a full shadow, as a factor, and `left`, what has not dissolved of it
 */
export function shadowedTone(
  arriving: number,
  taken: number,
  toneAt: (share: number) => number,
  blank: number,
  shadowTone: number,
  left: number,
): number {
  const share = 1 - taken / (arriving + taken + 1e-6);
  return Math.max(0, toneAt(share) - blank * share) * shadowTone * left;
}

/**
 * A line in a shadow of which so much is left, as a factor on its width there: the first end at 0.4 of what is left, the last at nothing.
 * What is left counts as a thousandth at least.
 */
export function leftOfLine(value: number, left: number): number {
  const end = 0.4 * lotOf(value);
  return clamp01((left - end) / (1 - end)) / Math.max(left, 1e-3);
}

/** The mean of that over all lots, by the middles of many even steps. */
export function meanLeft(left: number): number {
  const steps = 40_000;
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const end = (0.4 * (i + 0.5)) / steps;
    sum += clamp01((left - end) / (1 - end));
  }
  return sum / steps / left;
}

/** The axis of lines that run away from a light, on a ground whose normal leans least from an axis of space; null where it is overhead. */
export function axisAway(light: Vec3, normal: Vec3): Vec3 | null {
  // Of axes as near as one another it is the second, then the third.
  const nearest = [1, 2, 0].reduce((best, i) => (Math.abs(normal[i]) > Math.abs(normal[best]) ? i : best));
  const up: Vec3 = [0, 0, 0];
  up[nearest] = 1;
  const side = cross(light, up);
  return Math.hypot(...side) > 0.001 ? unit(side) : null;
}
