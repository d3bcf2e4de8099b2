import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { doubleArea } from '../mesh/computeAreaNormals.js';
import { triangleOf } from '../mesh/corners.js';
import { disjointSets, join, rootOf } from '../mesh/disjointSets.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';

/** What a mesh falls into along the edges without twins. */
export interface Patches {
  /** For each triangle the number of its patch. */
  ofTriangle: Uint32Array;
  /** The area of each, in square object units. */
  areas: Float64Array;
  /** How many triangles each has. */
  sizes: Uint32Array;
}

/** Finds the patches: sets of triangles bounded by edges without twins. */
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
    // Each edge once, and none without a twin.
    if (twins[corner] > corner) join(parents, triangleOf(corner), triangleOf(twins[corner]));
  }
}

/** Numbers the patches of some triangles; `count` are numbered already. The root is the smallest of its set, so it comes first. */
function numberRange(parents: Uint32Array, ofTriangle: Uint32Array, count: number, start: number, end: number): number {
  let next = count;
  for (let triangle = start; triangle < end; triangle++) {
    const root = rootOf(parents, triangle);
    ofTriangle[triangle] = root === triangle ? next++ : ofTriangle[root];
  }
  return next;
}

/** Adds the areas of some triangles to those of their patches, and counts them. */
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
