import type { ReferenceFragment } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

/** The value of an attribute at a fragment: xyz per vertex, interpolated over the triangle. */
export function interpolated(
  values: readonly number[],
  indices: readonly number[],
  { triangle, barycentric }: ReferenceFragment,
): Vec3 {
  return [0, 1, 2].map((axis) =>
    barycentric.reduce((sum, weight, k) => sum + weight * values[3 * indices[3 * triangle + k] + axis], 0),
  ) as Vec3;
}
