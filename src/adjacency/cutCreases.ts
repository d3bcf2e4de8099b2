import { NO_TWIN, triangleOf } from './corners.js';
import { inChunks } from './inChunks.js';

/** Rounding of the normals must not cut the edges of a mesh that is built with exactly the crease angle. */
const COSINE_TOLERANCE = 1e-6;

/**
 * Sets the twins of all edges to NO_TWIN, in place, where the normals of the two triangles differ by more than
 * `creaseAngle` radians: the neighbour then contributes nothing (paper, section 3.3). Returns the number of edges cut.
 */
export function* cutCreases(
  adjacency: { twins: Int32Array; canonicalCorners: Uint32Array; areaNormals: Float64Array },
  creaseAngle: number,
): Generator<number, number, void> {
  const { twins, canonicalCorners, areaNormals } = adjacency;
  const least = Math.cos(creaseAngle) - COSINE_TOLERANCE;
  let cuts = 0;
  yield* inChunks(twins.length, (start, end) => {
    for (let corner = start; corner < end; corner++) {
      const twin = twins[corner]!;
      if (twin < corner) continue;
      const cosine = cosineBetween(areaNormals, triangleOf(corner), triangleOf(twin));
      // The normal of a triangle wound the other way points to the other side.
      const isInconsistent = canonicalCorners[corner] === canonicalCorners[twin];
      if ((isInconsistent ? -cosine : cosine) >= least) continue;
      twins[corner] = NO_TWIN;
      twins[twin] = NO_TWIN;
      cuts++;
    }
  });
  return cuts;
}

function cosineBetween(areaNormals: Float64Array, a: number, b: number): number {
  const ax = areaNormals[3 * a]!;
  const ay = areaNormals[3 * a + 1]!;
  const az = areaNormals[3 * a + 2]!;
  const bx = areaNormals[3 * b]!;
  const by = areaNormals[3 * b + 1]!;
  const bz = areaNormals[3 * b + 2]!;
  // Two roots, not one: the product of four lengths could leave the range of doubles.
  return (
    (ax * bx + ay * by + az * bz) / (Math.sqrt(ax * ax + ay * ay + az * az) * Math.sqrt(bx * bx + by * by + bz * bz))
  );
}
