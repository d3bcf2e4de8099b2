import { asPhase, chunkPhase, release } from '../phases.js';
import type { FanSurface } from './assembleHeatEquation.js';
import type { Fans, SortedFans } from './fans.js';

/** A unit normal per fan: x, y, z in the order of the fans. */
export interface FanNormals {
  fans: Fans;
  normals: Float32Array<ArrayBuffer>;
}

/** Computes a unit normal per fan (x, y, z): the normalised sum of the area normals of its triangles. */
export function* computeSmoothNormals(
  areaNormals: Float64Array,
  fans: Fans,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const sums = new Float64Array(3 * fans.count);
  yield* chunkPhase(fans.ofCorner.length, 0, 0.6, (start, end) =>
    sumRange(areaNormals, fans.ofCorner, sums, start, end),
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

/**
 * Normalises the vector of each fan. A zero vector is replaced by the normal of the fan's first triangle or, if that triangle
 * is degenerate, by +z.
 */
export function* fanDirections(
  vectors: Float32Array | Float64Array,
  areaNormals: Float64Array,
  { ofCorner, count }: Fans,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const directions = new Float32Array(3 * count);
  let zeros = 0;
  yield* chunkPhase(count, 0, 0.5, (start, end) => {
    zeros += directRange(vectors, directions, start, end);
  });
  // Few fans, and mostly none, have no direction.
  if (zeros > 0) {
    yield* chunkPhase(ofCorner.length, 0.5, 1, (start, end) =>
      replaceRange(areaNormals, ofCorner, directions, start, end),
    );
  }
  return directions;
}

/** Normalises the vectors of a range of fans. Returns how many are zero. */
function directRange(
  vectors: Float32Array | Float64Array,
  directions: Float32Array,
  start: number,
  end: number,
): number {
  let zeros = 0;
  for (let i = 3 * start; i < 3 * end; i += 3) if (!writeNormalized(vectors, i, directions, i)) zeros++;
  return zeros;
}

/** Gives the fans of a range of corners the directions of their first triangles, if they have none. */
function replaceRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  directions: Float32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = 3 * ofCorner[corner];
    if (directions[fan] !== 0 || directions[fan + 1] !== 0 || directions[fan + 2] !== 0) continue;
    if (!writeNormalized(areaNormals, corner - (corner % 3), directions, fan)) directions[fan + 2] = 1;
  }
}

/** Normalises the vector at `from` and writes it to `to`. If it is zero, it writes nothing and returns false. */
function writeNormalized(source: Float32Array | Float64Array, from: number, target: Float32Array, to: number): boolean {
  const x = source[from];
  const y = source[from + 1];
  const z = source[from + 2];
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length === 0) return false;
  target[to] = x / length;
  target[to + 1] = y / length;
  target[to + 2] = z / length;
  return true;
}

/** The result of `meanNormals`. */
interface MeanNormals {
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
  yield* chunkPhase(areaNormals.length / 3, 0, 0.5, (start, end) =>
    sumNormalsRange(areaNormals, fans.ofCorner, numbers, sums, masses, start, end),
  );
  const normals = new Float32Array(3 * fans.count);
  yield* chunkPhase(fans.count, 0.5, 1, (start, end) => meanRange(sums, masses, normals, start, end));
  release(sums);
  return { normals, masses };
}

/** Adds the normals and masses of a range of triangles to those of their fans. */
function sumNormalsRange(
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
