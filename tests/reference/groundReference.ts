/** A ground that shows shadows alone, in double precision, by its documentation. Shares no code with the shader. */
import { hash01 } from './engravedStrokes.js';
import type { Vec3 } from './referenceAdjacency.js';
import { clamp01, cross, unit } from './vectors.js';

/**
 * The tone of a shadow. A millionth of light is added, so that there is no shadow where there is no light.
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
 * A factor on the width of a line in a shadow of which a share is left. A line begins to narrow in the order of its hash, and over 0.4 of
 * the range; the wider ones keep the mean. Only the earlier half of the order is used. The share counts as at least a thousandth.
 */
export function leftOfLine(value: number, left: number): number {
  const hash = hash01(value);
  const turn = hash < 0.5 ? hash + 0.5 : hash - 0.5;
  const least = Math.max(left, 1e-3);
  const steep = Math.min(0.4 * ((1 - left) / least), 2);
  const narrowed = (at: number) => clamp01(1 - at * steep);
  // The mean of a ramp up to its end.
  const end = Math.min(1, 1 / steep);
  return narrowed(turn) / (end * 0.5 * (1 + narrowed(end)));
}

/**
 * The axis of lines that run away from a light, on a ground whose normal is nearest to one of the coordinate axes; null if the light is
 * overhead.
 */
export function axisAway(light: Vec3, normal: Vec3): Vec3 | null {
  // Among equally near axes the second counts first, then the third.
  const nearest = [1, 2, 0].reduce((best, i) => (Math.abs(normal[i]) > Math.abs(normal[best]) ? i : best));
  const up: Vec3 = [0, 0, 0];
  up[nearest] = 1;
  const side = cross(light, up);
  return Math.hypot(...side) > 0.001 ? unit(side) : null;
}
