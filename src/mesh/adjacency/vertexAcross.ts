import { NO_TWIN, previousCorner } from '../corners.js';

/**
 * The opposite vertex of the neighbour across the edge that starts at `corner`. Without a neighbour it is the opposite vertex
 * of the corner's own triangle.
 */
export function vertexAcross(indices: Uint32Array, twins: Int32Array, corner: number): number {
  const twin = twins[corner];
  return indices[previousCorner(twin === NO_TWIN ? corner : twin)];
}
