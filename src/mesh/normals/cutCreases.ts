import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { cosineBetween } from '../computeAreaNormals.js';
import { NO_TWIN, triangleOf } from '../corners.js';
import { forEachChunk } from '../phases.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

/** Keeps rounding from treating equal edges differently on a mesh built with exactly the crease angle. */
const COSINE_TOLERANCE = 1e-6;

/**
 * Sets the twins of an edge to NO_TWIN, in place, where the normals of its two triangles differ by `creaseAngle` radians or
 * more. The neighbour then contributes nothing (Suarez et al., section 3.3: the faces of a cube do not influence each
 * other).
 */
export function* cutCreases(adjacency: Adjacency, creaseAngle: number): Generator<number, void, void> {
  const creaseCosine = Math.cos(creaseAngle) + COSINE_TOLERANCE;
  yield* forEachChunk(adjacency.twins.length, (start, end) => cutRange(adjacency, creaseCosine, start, end));
}

function cutRange(
  { twins, canonicalCorners, areaNormals }: Adjacency,
  creaseCosine: number,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin < corner) continue;
    const cosine = cosineBetween(areaNormals, triangleOf(corner), triangleOf(twin));
    // A triangle with the opposite winding has its normal on the other side.
    const isInconsistent = canonicalCorners[corner] === canonicalCorners[twin];
    if ((isInconsistent ? -cosine : cosine) > creaseCosine) continue;
    twins[corner] = NO_TWIN;
    twins[twin] = NO_TWIN;
  }
}
