import { NO_TWIN, previousCorner } from '../mesh/corners.js';

/** The vertex opposite to the edge in the neighbour across it. Without a neighbour, the opposite vertex of the own triangle. */
export function vertexAcross(indices: Uint32Array, twins: Int32Array, corner: number): number {
  const twin = twins[corner];
  return indices[previousCorner(twin === NO_TWIN ? corner : twin)];
}
