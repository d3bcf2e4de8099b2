import { sortedIndices } from './sortedIndices.js';

/**
 * Histogram equalization: replaces the numbers of `field`, which must not be negative, by others in the same order that are
 * evenly distributed over (0, 1).
 */
export function equalize(field: Float32Array): Float32Array {
  const order = sortedIndices(field);
  const ranks = new Float32Array(field.length);
  for (let rank = 0; rank < order.length; rank++) ranks[order[rank]] = (rank + 0.5) / order.length;
  return ranks;
}
