import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { doubleArea } from '../computeAreaNormals.js';
import { triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { chunkPhase, release } from '../phases.js';
import type { FanSurface } from './assembleHeatEquation.js';
import { type Fans, NO_FAN } from './fans.js';

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
  yield* chunkPhase(twins.length, 0, 0.6, (start, end) => joinRange(twins, parents, start, end));
  const ofTriangle = new Uint32Array(count);
  let patchCount = 0;
  yield* chunkPhase(count, 0.6, 0.8, (start, end) => {
    patchCount = numberRange(parents, ofTriangle, patchCount, start, end);
  });
  release(parents);
  const areas = new Float64Array(patchCount);
  const sizes = new Uint32Array(patchCount);
  yield* chunkPhase(count, 0.8, 1, (start, end) => addRange(areaNormals, ofTriangle, areas, sizes, start, end));
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

/**
 * Moves the corners of small patches, in place, to the largest fan at the same vertex that belongs to no small patch, if such a
 * fan exists. Small patches are too small for a stroke: the folds, spikes and doubled triangles of scans and decimated meshes,
 * and all degenerate triangles. An object that is small as a whole keeps its edges. The numbers of fans that become empty stay
 * unused.
 *
 * @param isSmall tells whether a patch is small, from its area in square object units and its number of triangles
 */
export function* absorbSmallPatches(
  { mesh, canonicalCorners, areaNormals }: Pick<FanSurface, 'mesh' | 'canonicalCorners' | 'areaNormals'>,
  { ofTriangle, areas, sizes }: Patches,
  { ofCorner, count }: Fans,
  isSmall: (area: number, triangles: number) => boolean,
): Generator<number, void, void> {
  const cornerCount = ofCorner.length;
  const small = new Uint8Array(areas.length);
  for (let patch = 0; patch < areas.length; patch++) small[patch] = Number(isSmall(areas[patch], sizes[patch]));
  if (!small.includes(1)) return;
  const isBeside = new Uint8Array(mesh.positions.length / 3);
  yield* chunkPhase(cornerCount / 3, 0, 0.3, (start, end) =>
    markRange(canonicalCorners, ofTriangle, small, isBeside, start, end),
  );
  // Small patches are few; the rest visits their vertices only.
  const corners: number[] = [];
  yield* chunkPhase(cornerCount, 0.3, 0.8, (start, end) =>
    collectRange(canonicalCorners, isBeside, corners, start, end),
  );
  const fanAreas = new Float64Array(count);
  yield* chunkPhase(corners.length, 0.8, 0.88, (start, end) =>
    addAreasRange(areaNormals, ofCorner, corners, fanAreas, start, end),
  );
  const search = { canonicalCorners, ofCorner, ofTriangle, small, largestFans: new Uint32Array(isBeside.length) };
  search.largestFans.fill(NO_FAN);
  yield* chunkPhase(corners.length, 0.88, 0.95, (start, end) => findLargestFans(search, corners, fanAreas, start, end));
  yield* chunkPhase(corners.length, 0.95, 1, (start, end) => moveRange(search, corners, start, end));
}

/** Marks the canonical vertices of the small patches in a range of triangles. */
function markRange(
  canonicalCorners: Uint32Array,
  ofTriangle: Uint32Array,
  small: Uint8Array,
  isBeside: Uint8Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    if (small[ofTriangle[triangle]] === 0) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) isBeside[canonicalCorners[corner]] = 1;
  }
}

/** Collects the corners at marked vertices. */
function collectRange(
  canonicalCorners: Uint32Array,
  isBeside: Uint8Array,
  corners: number[],
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) if (isBeside[canonicalCorners[corner]] === 1) corners.push(corner);
}

/** Adds the areas of the triangles of a range of corners to those of the corners' fans. */
function addAreasRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  corners: readonly number[],
  fanAreas: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) fanAreas[ofCorner[corners[i]]] += doubleArea(areaNormals, triangleOf(corners[i]));
}

/** The state of the search for the fans that absorb small patches. */
interface FanSearch {
  canonicalCorners: Uint32Array;
  ofCorner: Uint32Array;
  ofTriangle: Uint32Array;
  small: Uint8Array;
  /** For each canonical vertex the largest fan that belongs to no small patch, or NO_FAN. */
  largestFans: Uint32Array;
}

/** Finds the largest fans among those of a range of corners. */
function findLargestFans(
  { canonicalCorners, ofCorner, ofTriangle, small, largestFans }: FanSearch,
  corners: readonly number[],
  fanAreas: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const corner = corners[i];
    if (small[ofTriangle[triangleOf(corner)]] === 1) continue;
    const vertex = canonicalCorners[corner];
    const fan = ofCorner[corner];
    const largest = largestFans[vertex];
    if (largest === NO_FAN || fanAreas[fan] > fanAreas[largest]) largestFans[vertex] = fan;
  }
}

function moveRange(
  { canonicalCorners, ofCorner, ofTriangle, small, largestFans }: FanSearch,
  corners: readonly number[],
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const corner = corners[i];
    const largest = largestFans[canonicalCorners[corner]];
    if (largest !== NO_FAN && small[ofTriangle[triangleOf(corner)]] === 1) ofCorner[corner] = largest;
  }
}
