import { clusterPositions } from '../clusterPositions.js';
import { isDegenerate } from '../computeAreaNormals.js';
import { NO_TWIN, nextCorner, triangleOf } from '../corners.js';
import { hashWords } from '../hashWords.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';
import { comparePositions, matchNonManifoldEdge } from './matchNonManifoldEdge.js';
import type { Pairing } from './pairEdges.js';

/** The tolerances within which positions are joined, in object units. */
export interface Nearness {
  /** Positions may be joined if they differ by at most this much along each axis. 0 joins none. */
  tolerance: number;
  /** A side of a triangle that is at most this long along each axis is taken for a rounding error. At most `tolerance`. */
  rounding: number;
}

/** A mesh whose edges are paired, before its borders are joined. `joinBorders` changes it in place. */
interface PairedMesh {
  positions: Float32Array;
  /** Replaced by a copy where positions are joined. */
  canonicalCorners: Uint32Array<ArrayBuffer>;
  areaNormals: Float64Array;
  pairing: Pairing;
}

/** The largest extent of a set of joined positions along an axis, in tolerances. */
const MAX_EXTENT = 4;

/**
 * Joins border positions that lie within the tolerance of each other, then pairs the edges that coincide as a result. The
 * sphere of three.js needs it: sin 2π is computed as −2.4e−16, so its seam does not close exactly. Edges that are already
 * paired stay paired.
 *
 * A cluster is a connected component of positions within the tolerance of each other. It is not joined if it is wider than
 * four tolerances, or if it holds two corners of one triangle, since surface would be lost. Triangles with a side that is a
 * rounding error are an exception: they become degenerate when their corners are joined, as at the pole of three's capsule.
 */
export function* joinBorders(mesh: PairedMesh, { tolerance, rounding }: Nearness): Generator<number, void, void> {
  const { positions, pairing } = mesh;
  if (!(tolerance > 0) || pairing.borders.length === 0) return;
  const { near, steps } = yield* asPhase(findNearPositions(positions, endsOf(mesh), tolerance), 0, 0.2);
  const { first, steps: clusterSteps } = yield* asPhase(clusterPositions(positions, near, tolerance), 0.2, 0.5);
  pairing.steps += steps + clusterSteps;
  const joined = joinedVertices(positions, near, first, tolerance);
  if (joined === null) return;
  // They may be the indices of the mesh, which must not change.
  const canonicalCorners = mesh.canonicalCorners.slice();
  mesh.canonicalCorners = canonicalCorners;
  const corners: number[] = [];
  yield* chunkPhase(canonicalCorners.length, 0.5, 0.8, (start, end) =>
    findRange(canonicalCorners, joined, corners, start, end),
  );
  keepTriangles(mesh, joined, corners, rounding);
  collapseTriangles(mesh, joined, corners);
  for (const corner of corners) canonicalCorners[corner] = partner(joined, canonicalCorners[corner]);
  pairBorders(mesh);
}

/** The canonical vertices at the ends of all border edges, without repetition. */
function endsOf({ positions, canonicalCorners, pairing }: PairedMesh): Uint32Array {
  const isEnd = new Uint8Array(positions.length / 3);
  for (const corner of pairing.borders) {
    isEnd[canonicalCorners[corner]] = 1;
    isEnd[canonicalCorners[nextCorner(corner)]] = 1;
  }
  const ends = new Uint32Array(2 * pairing.borders.length);
  let count = 0;
  for (let vertex = 0; vertex < isEnd.length; vertex++) if (isEnd[vertex] === 1) ends[count++] = vertex;
  return ends.subarray(0, count);
}

/**
 * Returns for every vertex the vertex that it is joined with, plus 1; 0 where it is not joined. All vertices of a cluster are
 * joined with the one at the lexicographically smallest position, so the order of the vertices does not matter. Clusters that
 * are too wide are left out. Returns null if nothing is joined.
 */
function joinedVertices(
  positions: Float32Array,
  ends: Uint32Array,
  first: Uint32Array,
  tolerance: number,
): Uint32Array | null {
  const count = ends.length;
  const smallest = first.slice();
  const boxes = new Float32Array(6 * count).fill(-Infinity);
  let clusterCount = 0;
  for (let i = 0; i < count; i++) {
    const cluster = first[i];
    if (cluster === i) clusterCount++;
    if (comparePositions(positions, 3 * ends[i], 3 * ends[smallest[cluster]]) < 0) smallest[cluster] = i;
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * ends[i] + axis];
      boxes[6 * cluster + axis] = Math.max(boxes[6 * cluster + axis], value);
      boxes[6 * cluster + 3 + axis] = Math.max(boxes[6 * cluster + 3 + axis], -value);
    }
  }
  if (clusterCount === count) return null;
  const joined = new Uint32Array(positions.length / 3);
  const sizes = new Uint32Array(count);
  for (let i = 0; i < count; i++) sizes[first[i]]++;
  for (let i = 0; i < count; i++) {
    const box = 6 * first[i];
    const isNarrow = [0, 1, 2].every((axis) => boxes[box + axis] + boxes[box + 3 + axis] <= MAX_EXTENT * tolerance);
    if (sizes[first[i]] > 1 && isNarrow) joined[ends[i]] = ends[smallest[first[i]]] + 1;
  }
  return joined;
}

/** The vertex that `vertex` is joined with, or `vertex` itself. */
const partner = (joined: Uint32Array, vertex: number): number => (joined[vertex] === 0 ? vertex : joined[vertex] - 1);

/** Adds those corners of a range that lie at joined vertices to `corners`. */
function findRange(
  canonicalCorners: Uint32Array,
  joined: Uint32Array,
  corners: number[],
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) if (joined[canonicalCorners[corner]] !== 0) corners.push(corner);
}

/** Removes every cluster that would collapse a triangle whose side is longer than a rounding error. */
function keepTriangles(
  { positions, canonicalCorners, areaNormals }: PairedMesh,
  joined: Uint32Array,
  corners: readonly number[],
  rounding: number,
): void {
  const kept = new Set<number>();
  for (const corner of corners) {
    const a = canonicalCorners[corner];
    const b = canonicalCorners[nextCorner(corner)];
    if (joined[a] !== joined[b] || a === b || isDegenerate(areaNormals, triangleOf(corner))) continue;
    for (let axis = 0; axis < 3; axis++) {
      if (Math.abs(positions[3 * a + axis] - positions[3 * b + axis]) > rounding) kept.add(joined[a]);
    }
  }
  for (const corner of corners) {
    const vertex = canonicalCorners[corner];
    if (kept.has(joined[vertex])) joined[vertex] = 0;
  }
}

/** Makes triangles degenerate if two of their corners are joined. */
function collapseTriangles(mesh: PairedMesh, joined: Uint32Array, corners: readonly number[]): void {
  const { canonicalCorners, areaNormals } = mesh;
  for (const corner of corners) {
    const a = joined[canonicalCorners[corner]];
    const b = joined[canonicalCorners[nextCorner(corner)]];
    const triangle = triangleOf(corner);
    if (a !== 0 && a === b && !isDegenerate(areaNormals, triangle)) collapse(mesh, 3 * triangle);
  }
}

/** Makes the triangle that starts at the corner `first` degenerate. The edges of its neighbours become borders. */
function collapse({ canonicalCorners, areaNormals, pairing }: PairedMesh, first: number): void {
  pairing.degenerateTriangles++;
  areaNormals.fill(0, first, first + 3);
  for (let corner = first; corner < first + 3; corner++) {
    const twin = pairing.twins[corner];
    if (twin === NO_TWIN) continue;
    if (canonicalCorners[corner] === canonicalCorners[twin]) pairing.inconsistentEdges--;
    pairing.twins[corner] = NO_TWIN;
    pairing.twins[twin] = NO_TWIN;
    pairing.borders.push(twin);
  }
}

/** Pairs the border edges whose ends have become the same. */
function pairBorders({ positions, canonicalCorners, areaNormals, pairing }: PairedMesh): void {
  const { twins } = pairing;
  const vertexCount = positions.length / 3;
  const open = pairing.borders.filter((corner) => !isDegenerate(areaNormals, triangleOf(corner)));
  const latest = new Map<number, number>();
  const previous = new Int32Array(open.length);
  for (const [i, corner] of open.entries()) {
    const from = canonicalCorners[corner];
    const to = canonicalCorners[nextCorner(corner)];
    const edge = Math.min(from, to) * vertexCount + Math.max(from, to);
    previous[i] = latest.get(edge) ?? -1;
    latest.set(edge, i);
  }
  pairing.borders = [];
  for (const last of latest.values()) {
    const corner = open[last];
    const second = previous[last];
    if (second < 0) {
      pairing.borders.push(corner);
    } else if (previous[second] < 0) {
      const twin = open[second];
      twins[corner] = twin;
      twins[twin] = corner;
      if (canonicalCorners[corner] === canonicalCorners[twin]) pairing.inconsistentEdges++;
    } else {
      const group: number[] = [];
      for (let member = last; member >= 0; member = previous[member]) group.push(open[member]);
      matchNonManifoldEdge(group, positions, canonicalCorners, pairing);
    }
  }
  pairing.steps += open.length;
}

/** The result of `findNearPositions`. */
interface NearPositions {
  /** The entries of `vertices` that may be near another position, in the same order. */
  near: Uint32Array<ArrayBuffer>;
  /** Hash slots visited: a machine-independent measure of the time taken. */
  steps: number;
}

/** Side of a grid cell, in tolerances. At this size most boxes lie in one cell, and few cells hold two. */
const CELL = 16;

/** Half a side of the box around a position, in tolerances. Above 0.5, so that rounding cannot separate boxes that touch. */
const REACH = 0.51;

/**
 * Finds the positions that may differ from another one by no more than `tolerance` along each axis. It leaves out most of the
 * others, at a fraction of the cost of a search of their neighbourhood. Each position has a box around it with sides of one
 * tolerance. The boxes of two near positions touch, so some cell of a coarse grid holds a part of both. Cells are kept in a
 * hash table; positions whose cells collide in it count as near.
 *
 * @param vertices the numbers of the positions to look at
 * @param tolerance above 0, and not below 2⁻⁴⁰ of the extent of the positions
 */
export function* findNearPositions(
  positions: Float32Array,
  vertices: Uint32Array,
  tolerance: number,
): Generator<number, NearPositions, void> {
  let size = 16;
  while (size < 8 * vertices.length) size *= 2;
  const table = new Uint32Array(size);
  const isNear = new Uint8Array(vertices.length);
  let steps = 0;
  yield* forEachChunk(vertices.length, (start, end) => {
    steps += enterRange(positions, vertices, tolerance, table, isNear, start, end);
  });
  const near = new Uint32Array(vertices.length);
  let count = 0;
  for (let i = 0; i < vertices.length; i++) if (isNear[i] === 1) near[count++] = vertices[i];
  return { near: near.subarray(0, count), steps };
}

/** Enters positions into `table` (entry + 1; 0 is an empty slot) and marks those that meet. Returns the count of slots visited. */
function enterRange(
  positions: Float32Array,
  vertices: Uint32Array,
  tolerance: number,
  table: Uint32Array,
  isNear: Uint8Array,
  start: number,
  end: number,
): number {
  const mask = table.length - 1;
  const scale = 1 / (CELL * tolerance);
  const reach = REACH / CELL;
  let steps = 0;
  for (let i = start; i < end; i++) {
    // The offset puts the planes through the origin, where many borders lie, into the middle of cells.
    const x = positions[3 * vertices[i]] * scale + 0.5;
    const y = positions[3 * vertices[i] + 1] * scale + 0.5;
    const z = positions[3 * vertices[i] + 2] * scale + 0.5;
    const lastX = Math.floor(x + reach);
    const lastY = Math.floor(y + reach);
    const lastZ = Math.floor(z + reach);
    for (let cellZ = Math.floor(z - reach); cellZ <= lastZ; cellZ++) {
      for (let cellY = Math.floor(y - reach); cellY <= lastY; cellY++) {
        for (let cellX = Math.floor(x - reach); cellX <= lastX; cellX++) {
          const slot = hashWords(cellX, cellY, cellZ) & mask;
          const other = table[slot] - 1;
          steps++;
          if (other < 0) table[slot] = i + 1;
          else isNear[i] = isNear[other] = 1;
        }
      }
    }
  }
  return steps;
}
