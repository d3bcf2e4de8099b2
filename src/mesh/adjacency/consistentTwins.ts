import { NO_TWIN } from '../corners.js';
import { forEachChunk } from '../phases.js';
import type { TriangleAdjacency } from './buildTriangleAdjacency.js';

/**
 * Returns the twins, with NO_TWIN also where the windings of the two triangles contradict each other.
 *
 * @param consistent the twins of the adjacency, which are changed; by default a copy
 */
export function* consistentTwins(
  {
    twins,
    canonicalCorners,
    inconsistentEdges,
  }: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'inconsistentEdges'>,
  consistent: Int32Array<ArrayBuffer> = twins.slice(),
): Generator<number, Int32Array<ArrayBuffer>, void> {
  if (inconsistentEdges === 0) return consistent;
  yield* forEachChunk(twins.length, (start, end) => dropRange(canonicalCorners, consistent, start, end));
  return consistent;
}

/** Half-edges are judged one by one; both halves of an edge get the same result. */
function dropRange(canonicalCorners: Uint32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin !== NO_TWIN && canonicalCorners[corner] === canonicalCorners[twin]) twins[corner] = NO_TWIN;
  }
}
