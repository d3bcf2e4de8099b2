import { doubleArea } from '../mesh/computeAreaNormals.js';
import { triangleOf } from '../mesh/corners.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { FanSurface } from './assembleHeatEquation.js';
import { type Fans, NO_FAN } from './buildFans.js';
import type { Patches } from './findPatches.js';

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
  const fanAreas = new Float64Array(count);
  yield* asPhase(
    forEachChunk(cornerCount / 3, (start, end) => addFans(areaNormals, ofCorner, fanAreas, start, end)),
    0,
    0.4,
  );
  const largestFans = new Uint32Array(mesh.positions.length / 3).fill(NO_FAN);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) =>
      findLargestFans(canonicalCorners, ofCorner, fanAreas, ofTriangle, small, largestFans, start, end),
    ),
    0.4,
    0.7,
  );
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) =>
      moveRange(canonicalCorners, ofCorner, ofTriangle, small, largestFans, start, end),
    ),
    0.7,
    1,
  );
}

/** Adds the area of each triangle in a range to those of its fans. */
function addFans(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  fanAreas: Float64Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const area = 0.5 * doubleArea(areaNormals, triangle);
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) fanAreas[ofCorner[corner]] += area;
  }
}

/** Finds for each canonical vertex the largest fan that belongs to no small patch, or NO_FAN. */
function findLargestFans(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  fanAreas: Float64Array,
  ofTriangle: Uint32Array,
  small: Uint8Array,
  largestFans: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    if (small[ofTriangle[triangleOf(corner)]] === 1) continue;
    const vertex = canonicalCorners[corner];
    const fan = ofCorner[corner];
    const largest = largestFans[vertex];
    if (largest === NO_FAN || fanAreas[fan] > fanAreas[largest]) largestFans[vertex] = fan;
  }
}

function moveRange(
  canonicalCorners: Uint32Array,
  ofCorner: Uint32Array,
  ofTriangle: Uint32Array,
  small: Uint8Array,
  largestFans: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    if (small[ofTriangle[triangleOf(corner)]] === 0) continue;
    const largest = largestFans[canonicalCorners[corner]];
    if (largest !== NO_FAN) ofCorner[corner] = largest;
  }
}
