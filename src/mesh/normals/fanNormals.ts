import { asPhase, forEachChunk } from '../phases.js';
import type { Fans } from './buildFans.js';

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
  yield* asPhase(
    forEachChunk(count, (start, end) => {
      zeros += directRange(vectors, directions, start, end);
    }),
    0,
    0.5,
  );
  // Few fans, and mostly none, have no direction.
  if (zeros > 0) {
    yield* asPhase(
      forEachChunk(ofCorner.length, (start, end) => replaceRange(areaNormals, ofCorner, directions, start, end)),
      0.5,
      1,
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
