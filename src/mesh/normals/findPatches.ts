import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { doubleArea } from '../computeAreaNormals.js';
import { triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { asPhase, forEachChunk, release } from '../phases.js';

/** The patches of a mesh: sets of triangles that are connected across edges with twins. */
export interface Patches {
  /** For each triangle the number of its patch. */
  ofTriangle: Uint32Array;
  /** The area of each patch, in square object units. */
  areas: Float64Array;
  /** The number of triangles of each patch. */
  sizes: Uint32Array;
}

/** Finds the patches of a mesh. */
export function* findPatches({
  twins,
  areaNormals,
}: Pick<TriangleAdjacency, 'twins' | 'areaNormals'>): Generator<number, Patches, void> {
  const count = twins.length / 3;
  const parents = disjointSets(count);
  yield* asPhase(
    forEachChunk(twins.length, (start, end) => joinRange(twins, parents, start, end)),
    0,
    0.6,
  );
  const ofTriangle = new Uint32Array(count);
  let patchCount = 0;
  yield* asPhase(
    forEachChunk(count, (start, end) => {
      patchCount = numberRange(parents, ofTriangle, patchCount, start, end);
    }),
    0.6,
    0.8,
  );
  release(parents);
  const areas = new Float64Array(patchCount);
  const sizes = new Uint32Array(patchCount);
  yield* asPhase(
    forEachChunk(count, (start, end) => addRange(areaNormals, ofTriangle, areas, sizes, start, end)),
    0.8,
    1,
  );
  return { ofTriangle, areas, sizes };
}

function joinRange(twins: Int32Array, parents: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    // This takes each edge once, and skips those without a twin.
    if (twins[corner] > corner) join(parents, triangleOf(corner), triangleOf(twins[corner]));
  }
}

/**
 * Numbers the patches of a range of triangles. `count` patches have a number already. The root of a set is its smallest
 * member, so it gets its number before the others look it up.
 */
function numberRange(parents: Uint32Array, ofTriangle: Uint32Array, count: number, start: number, end: number): number {
  let next = count;
  for (let triangle = start; triangle < end; triangle++) {
    const root = rootOf(parents, triangle);
    ofTriangle[triangle] = root === triangle ? next++ : ofTriangle[root];
  }
  return next;
}

/** Adds the area of each triangle in a range to that of its patch, and counts the triangles. */
function addRange(
  areaNormals: Float64Array,
  ofTriangle: Uint32Array,
  areas: Float64Array,
  sizes: Uint32Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const patch = ofTriangle[triangle];
    areas[patch] += 0.5 * doubleArea(areaNormals, triangle);
    sizes[patch]++;
  }
}
