import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { consistentTwin } from '../adjacency/consistentTwin.js';
import { doubleArea } from '../mesh/computeAreaNormals.js';
import { triangleOf } from '../mesh/corners.js';
import { disjointSets, join, rootOf } from '../mesh/disjointSets.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { Fans } from './buildFans.js';

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'areaNormals'>;

const NO_FAN = 0xffffffff;

/**
 * Moves the corners of small patches, in place, to the largest fan at their vertex that belongs to no small patch, if there
 * is one. A patch is a set of triangles bounded by edges without twins. Small patches are the folds, spikes and doubled triangles of scans and decimated meshes, and all
 * degenerate triangles: too small for a stroke. An object that is small as a whole keeps its edges. The numbers of emptied
 * fans stay unused.
 *
 * @param isSmall says so of a patch, by its area in square object units and its number of triangles
 */
export function* absorbSmallPatches(
  adjacency: Adjacency,
  { ofCorner, count }: Fans,
  isSmall: (area: number, triangles: number) => boolean,
): Generator<number, void, void> {
  const { canonicalCorners, areaNormals } = adjacency;
  const cornerCount = ofCorner.length;
  const patches = disjointSets(cornerCount / 3);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => joinRange(adjacency, patches, start, end)),
    0,
    0.4,
  );
  const patchAreas = new Float64Array(cornerCount / 3);
  const patchSizes = new Uint32Array(cornerCount / 3);
  const fanAreas = new Float64Array(count);
  yield* asPhase(
    forEachChunk(cornerCount / 3, (start, end) =>
      addAreas(areaNormals, ofCorner, patches, patchAreas, patchSizes, fanAreas, start, end),
    ),
    0.4,
    0.6,
  );
  const isInSmall = (corner: number): boolean => {
    const patch = rootOf(patches, triangleOf(corner));
    return isSmall(patchAreas[patch], patchSizes[patch]);
  };
  let vertexCount = 0;
  for (let corner = 0; corner < cornerCount; corner++)
    vertexCount = Math.max(vertexCount, canonicalCorners[corner] + 1);
  const largestFans = new Uint32Array(vertexCount).fill(NO_FAN);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) =>
      findLargestFans(canonicalCorners, ofCorner, fanAreas, isInSmall, largestFans, start, end),
    ),
    0.6,
    0.8,
  );
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) =>
      moveRange(canonicalCorners, ofCorner, isInSmall, largestFans, start, end),
    ),
    0.8,
    1,
  );
}

function joinRange({ twins, canonicalCorners }: Adjacency, patches: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = consistentTwin(twins, canonicalCorners, corner);
    if (twin < corner) continue;
    join(patches, triangleOf(corner), triangleOf(twin));
  }
}

/** Adds the areas of some triangles to those of their patches and of their fans, and counts them. */
function addAreas(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  patches: Uint32Array,
  patchAreas: Float64Array,
  patchSizes: Uint32Array,
  fanAreas: Float64Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const area = 0.5 * doubleArea(areaNormals, triangle);
    const patch = rootOf(patches, triangle);
    patchAreas[patch] += area;
    patchSizes[patch]++;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) fanAreas[ofCorner[corner]] += area;
  }
}

/** Finds for each canonical vertex the largest fan that belongs to no small patch, or NO_FAN. */
function findLargestFans(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  fanAreas: Float64Array,
  isSmall: (corner: number) => boolean,
  largestFans: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const vertex = canonicalCorners[corner];
    const fan = ofCorner[corner];
    const largest = largestFans[vertex];
    if (largest === fan || isSmall(corner)) continue;
    if (largest === NO_FAN || fanAreas[fan] > fanAreas[largest]) largestFans[vertex] = fan;
  }
}

function moveRange(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  isSmall: (corner: number) => boolean,
  largestFans: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const largest = largestFans[canonicalCorners[corner]];
    if (largest !== NO_FAN && largest !== ofCorner[corner] && isSmall(corner)) ofCorner[corner] = largest;
  }
}
