import { asPhase, forEachChunk, release } from '../phases.js';
import type { FanSurface } from './assembleHeatEquation.js';
import type { SortedFans } from './sortFans.js';

/** The result of `meanNormals`. */
export interface MeanNormals {
  /** For each fan the mean of the normals of its triangles, weighted by area: three floats. Not of unit length. */
  normals: Float32Array<ArrayBuffer>;
  /** For each fan a third of the area of its triangles. */
  masses: Float64Array<ArrayBuffer>;
}

/** Computes the mean normal and the mass of each sorted fan. */
export function* meanNormals(
  { fans, areaNormals }: Pick<FanSurface, 'fans' | 'areaNormals'>,
  { numbers }: Pick<SortedFans, 'numbers'>,
): Generator<number, MeanNormals, void> {
  const sums = new Float64Array(3 * fans.count);
  const masses = new Float64Array(fans.count);
  yield* asPhase(
    forEachChunk(areaNormals.length / 3, (start, end) =>
      sumRange(areaNormals, fans.ofCorner, numbers, sums, masses, start, end),
    ),
    0,
    0.5,
  );
  const normals = new Float32Array(3 * fans.count);
  yield* asPhase(
    forEachChunk(fans.count, (start, end) => meanRange(sums, masses, normals, start, end)),
    0.5,
    1,
  );
  release(sums);
  return { normals, masses };
}

/** Adds the normals and masses of a range of triangles to those of their fans. */
function sumRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  numbers: Uint32Array,
  sums: Float64Array,
  masses: Float64Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    // This makes the length a third of the area, since area normals are twice the area long.
    const x = areaNormals[first] / 6;
    const y = areaNormals[first + 1] / 6;
    const z = areaNormals[first + 2] / 6;
    const mass = Math.sqrt(x * x + y * y + z * z);
    for (let corner = first; corner < first + 3; corner++) {
      const fan = numbers[ofCorner[corner]];
      masses[fan] += mass;
      sums[3 * fan] += x;
      sums[3 * fan + 1] += y;
      sums[3 * fan + 2] += z;
    }
  }
}

function meanRange(sums: Float64Array, masses: Float64Array, means: Float32Array, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    const mass = masses[fan] || 1;
    means[3 * fan] = sums[3 * fan] / mass;
    means[3 * fan + 1] = sums[3 * fan + 1] / mass;
    means[3 * fan + 2] = sums[3 * fan + 2] / mass;
  }
}
