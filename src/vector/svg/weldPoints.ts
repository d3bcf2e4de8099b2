import { asPhase } from '../../mesh/phases.js';
import { weldPositions } from '../../mesh/weldPositions.js';

/** Distance below which points are at one place, as a share of the size of all. */
const TOLERANCE = 1e-6;
/** Points per step. */
const CHUNK = 8192;

/**
 * For each point the first one at the same place within rounding, since surfaces continue across seams of uvs and normals. Yields its
 * progress.
 *
 * @param coordinate of a point along an axis, from 0 to 2
 */
export function* weldPoints(
  count: number,
  coordinate: (point: number, axis: number) => number,
): Generator<number, Uint32Array, void> {
  let size = 0;
  for (let p = 0; p < count; p++) {
    if (p % CHUNK === 0) yield (0.2 * p) / count;
    for (let axis = 0; axis < 3; axis++) size = Math.max(size, Math.abs(coordinate(p, axis)));
  }
  const cell = size * TOLERANCE || 1;
  const cells = new Int32Array(3 * count);
  for (let p = 0; p < count; p++) {
    if (p % CHUNK === 0) yield 0.2 + (0.3 * p) / count;
    for (let axis = 0; axis < 3; axis++) cells[3 * p + axis] = Math.round(coordinate(p, axis) / cell);
  }
  // Only bits are compared.
  return (yield* asPhase(weldPositions(new Float32Array(cells.buffer)), 0.5, 1)).canonical;
}

/** For each point the first one at the same place in both of two lists. */
export function weldBoth(one: Uint32Array, other: Uint32Array): Uint32Array {
  const known = new Map<number, number>();
  return one.map((place, point) => {
    const key = place * 2 ** 26 + other[point];
    const first = known.get(key) ?? point;
    if (first === point) known.set(key, point);
    return first;
  });
}
