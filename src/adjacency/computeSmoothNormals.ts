import type { TriangleAdjacency } from './buildTriangleAdjacency.js';
import { NO_TWIN, nextCorner } from './corners.js';
import { asPhase, inChunks } from './inChunks.js';

/**
 * A normal per corner: the sum of the area normals of the triangles around the vertex that can be reached without
 * crossing an edge that has no twin. So normals are smooth across welded seams and split at borders, at creases cut
 * before, and where windings contradict each other (a sum would cancel there).
 *
 * Union-find over corners: near-linear also where 100,000 triangles meet.
 */
export function* computeSmoothNormals(
  adjacency: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const { twins, canonicalCorners, areaNormals } = adjacency;
  const cornerCount = twins.length;
  const parents = new Uint32Array(cornerCount);
  for (let corner = 0; corner < cornerCount; corner++) parents[corner] = corner;

  const rootOf = (corner: number): number => {
    let root = corner;
    while (parents[root] !== root) {
      parents[root] = parents[parents[root]!]!;
      root = parents[root]!;
    }
    return root;
  };
  const join = (a: number, b: number): void => {
    const rootA = rootOf(a);
    const rootB = rootOf(b);
    if (rootA < rootB) parents[rootB] = rootA;
    else parents[rootA] = rootB;
  };

  yield* asPhase(
    inChunks(cornerCount, (start, end) => {
      for (let corner = start; corner < end; corner++) {
        const twin = twins[corner]!;
        if (twin === NO_TWIN || twin < corner || canonicalCorners[corner] === canonicalCorners[twin]) continue;
        join(corner, nextCorner(twin));
        join(nextCorner(corner), twin);
      }
    }),
    0,
    0.4,
  );

  const sums = new Float64Array(3 * cornerCount);
  yield* asPhase(
    inChunks(cornerCount, (start, end) => {
      for (let corner = start; corner < end; corner++) {
        const root = 3 * rootOf(corner);
        const own = corner - (corner % 3);
        sums[root]! += areaNormals[own]!;
        sums[root + 1]! += areaNormals[own + 1]!;
        sums[root + 2]! += areaNormals[own + 2]!;
      }
    }),
    0.4,
    0.7,
  );

  const normals = new Float32Array(3 * cornerCount);
  yield* asPhase(
    inChunks(cornerCount, (start, end) => {
      for (let corner = start; corner < end; corner++) {
        const own = corner - (corner % 3);
        // Where the sum cancels, the triangle's own normal; where that is zero too (degenerate), any unit vector.
        if (!writeUnit(sums, 3 * rootOf(corner), normals, 3 * corner)) {
          if (!writeUnit(areaNormals, own, normals, 3 * corner)) normals[3 * corner + 2] = 1;
        }
      }
    }),
    0.7,
    1,
  );
  return normals;
}

/** Writes the direction of the vector at `from`; false if it has none. */
function writeUnit(source: Float64Array, from: number, target: Float32Array, to: number): boolean {
  const x = source[from]!;
  const y = source[from + 1]!;
  const z = source[from + 2]!;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length === 0) return false;
  target[to] = x / length;
  target[to + 1] = y / length;
  target[to + 2] = z / length;
  return true;
}
