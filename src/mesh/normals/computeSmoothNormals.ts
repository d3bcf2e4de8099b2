import { asPhase } from '../timeSlicing/asPhase.js';
import { forEachChunk } from '../timeSlicing/forEachChunk.js';
import type { Fans } from './buildFans.js';
import { fanDirections } from './fanDirections.js';

/** Computes a unit normal per fan (x, y, z): the normalised sum of the area normals of its triangles. */
export function* computeSmoothNormals(
  areaNormals: Float64Array,
  fans: Fans,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const sums = new Float64Array(3 * fans.count);
  yield* asPhase(
    forEachChunk(fans.ofCorner.length, (start, end) => sumRange(areaNormals, fans.ofCorner, sums, start, end)),
    0,
    0.6,
  );
  return yield* asPhase(fanDirections(sums, areaNormals, fans), 0.6, 1);
}

function sumRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  sums: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = 3 * ofCorner[corner];
    const own = corner - (corner % 3);
    sums[fan] += areaNormals[own];
    sums[fan + 1] += areaNormals[own + 1];
    sums[fan + 2] += areaNormals[own + 2];
  }
}
