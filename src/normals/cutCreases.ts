import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, triangleOf } from '../mesh/corners.js';
import { forEachChunk } from '../slices/forEachChunk.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

/** Rounding of the normals must not keep some edges of a mesh that is built with exactly the crease angle, and cut others. */
const COSINE_TOLERANCE = 1e-6;

/**
 * Sets the twins of all edges to NO_TWIN, in place, where the normals of the two triangles differ by
 * `creaseAngle` radians or more: the neighbour then contributes nothing (paper, section 3.3: the faces of a cube do not
 * influence each other).
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
    const cosine = cosineBetween(areaNormals, 3 * triangleOf(corner), 3 * triangleOf(twin));
    // The normal of a triangle that is wound the other way points to the other side.
    const isInconsistent = canonicalCorners[corner] === canonicalCorners[twin];
    if ((isInconsistent ? -cosine : cosine) > creaseCosine) continue;
    twins[corner] = NO_TWIN;
    twins[twin] = NO_TWIN;
  }
}

function cosineBetween(normals: Float64Array, a: number, b: number): number {
  const ax = normals[a];
  const ay = normals[a + 1];
  const az = normals[a + 2];
  const bx = normals[b];
  const by = normals[b + 1];
  const bz = normals[b + 2];
  // Two roots, not one: the product of the squares could leave the range of doubles.
  const lengths = Math.sqrt(ax * ax + ay * ay + az * az) * Math.sqrt(bx * bx + by * by + bz * bz);
  return (ax * bx + ay * by + az * bz) / lengths;
}
