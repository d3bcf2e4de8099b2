import type { TriangleAdjacency } from './buildTriangleAdjacency.js';
import { NO_TWIN, nextCorner } from './corners.js';
import { asPhase, inChunks } from './inChunks.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

/**
 * A normal per corner: the sum of the area normals of the triangles around the vertex that can be reached without
 * crossing an edge that has no twin. So normals are smooth across welded seams, and split at borders, at creases that
 * were cut before, and where windings contradict each other (a sum would cancel there).
 *
 * Union-find over corners: near-linear also where 100,000 triangles meet.
 */
export function* computeSmoothNormals(adjacency: Adjacency): Generator<number, Float32Array<ArrayBuffer>, void> {
  const { areaNormals } = adjacency;
  const cornerCount = adjacency.twins.length;
  const parents = new Uint32Array(cornerCount);
  for (let corner = 0; corner < cornerCount; corner++) parents[corner] = corner;
  const sums = new Float64Array(3 * cornerCount);
  const normals = new Float32Array(3 * cornerCount);
  yield* asPhase(
    inChunks(cornerCount, (start, end) => joinRange(adjacency, parents, start, end)),
    0,
    0.4,
  );
  yield* asPhase(
    inChunks(cornerCount, (start, end) => sumRange(areaNormals, parents, sums, start, end)),
    0.4,
    0.7,
  );
  yield* asPhase(
    inChunks(cornerCount, (start, end) => normalizeRange(areaNormals, parents, sums, normals, start, end)),
    0.7,
    1,
  );
  return normals;
}

/** Joins the two corners at either end of an edge with those of its twin. */
function joinRange({ twins, canonicalCorners }: Adjacency, parents: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner]!;
    if (twin === NO_TWIN || twin < corner || canonicalCorners[corner] === canonicalCorners[twin]) continue;
    join(parents, corner, nextCorner(twin));
    join(parents, nextCorner(corner), twin);
  }
}

/** Union-find: the smallest corner of the set. Shortens the path by half on the way. */
function rootOf(parents: Uint32Array, corner: number): number {
  let root = corner;
  for (let parent = parents[root]!; parent !== root; parent = parents[root]!) {
    const grandparent = parents[parent]!;
    parents[root] = grandparent;
    root = grandparent;
  }
  return root;
}

function join(parents: Uint32Array, a: number, b: number): void {
  const rootA = rootOf(parents, a);
  const rootB = rootOf(parents, b);
  parents[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
}

function sumRange(
  areaNormals: Float64Array,
  parents: Uint32Array,
  sums: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const root = 3 * rootOf(parents, corner);
    const own = corner - (corner % 3);
    sums[root]! += areaNormals[own]!;
    sums[root + 1]! += areaNormals[own + 1]!;
    sums[root + 2]! += areaNormals[own + 2]!;
  }
}

function normalizeRange(
  areaNormals: Float64Array,
  parents: Uint32Array,
  sums: Float64Array,
  normals: Float32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    if (writeUnit(sums, 3 * rootOf(parents, corner), normals, 3 * corner)) continue;
    // Where the sum cancels, the triangle's own normal; where that is zero too (degenerate), any unit vector.
    if (!writeUnit(areaNormals, corner - (corner % 3), normals, 3 * corner)) normals[3 * corner + 2] = 1;
  }
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
