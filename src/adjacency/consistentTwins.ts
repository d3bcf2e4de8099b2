import { NO_TWIN } from '../mesh/corners.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { TriangleAdjacency } from './buildTriangleAdjacency.js';

/** Returns a copy of the twins that also has NO_TWIN where the windings of the two triangles contradict each other. */
export function* consistentTwins({
  twins,
  canonicalCorners,
  inconsistentEdges,
}: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'inconsistentEdges'>): Generator<
  number,
  Int32Array<ArrayBuffer>,
  void
> {
  const consistent = twins.slice();
  if (inconsistentEdges === 0) return consistent;
  yield* forEachChunk(twins.length, (start, end) => dropRange(canonicalCorners, consistent, start, end));
  return consistent;
}

/** Each half-edge is judged by itself. The two halves of an edge always get the same result. */
function dropRange(canonicalCorners: Uint32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin !== NO_TWIN && canonicalCorners[corner] === canonicalCorners[twin]) twins[corner] = NO_TWIN;
  }
}
