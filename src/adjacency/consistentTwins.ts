import { NO_TWIN } from '../mesh/corners.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { TriangleAdjacency } from './buildTriangleAdjacency.js';

/** A copy of the twins with NO_TWIN also where the two windings contradict each other. */
export function* consistentTwins({
  twins,
  canonicalCorners,
}: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners'>): Generator<number, Int32Array<ArrayBuffer>, void> {
  const consistent = twins.slice();
  yield* forEachChunk(twins.length, (start, end) => dropRange(canonicalCorners, consistent, start, end));
  return consistent;
}

/** Each half-edge judges itself, and both of an edge come to the same verdict. */
function dropRange(canonicalCorners: Uint32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin !== NO_TWIN && canonicalCorners[corner] === canonicalCorners[twin]) twins[corner] = NO_TWIN;
  }
}
