import { NO_TWIN, previousCorner } from '../mesh/corners.js';

/** The vertex opposite to the edge in the neighbour across it or, where there is none, in the triangle itself. */
export function vertexAcross(indices: Uint32Array, twins: Int32Array, corner: number): number {
  const twin = twins[corner];
  return indices[previousCorner(twin === NO_TWIN ? corner : twin)];
}
