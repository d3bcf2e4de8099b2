import { forEachChunk } from '../slices/forEachChunk.js';
import type { Fans } from './buildFans.js';
import { writeNormalized } from './writeNormalized.js';

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
  yield* forEachChunk(ofCorner.length, (start, end) =>
    directRange(vectors, areaNormals, ofCorner, directions, start, end),
  );
  return directions;
}

function directRange(
  vectors: Float32Array | Float64Array,
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  directions: Float32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = 3 * ofCorner[corner];
    if (directions[fan] !== 0 || directions[fan + 1] !== 0 || directions[fan + 2] !== 0) continue;
    if (writeNormalized(vectors, fan, directions, fan)) continue;
    if (!writeNormalized(areaNormals, corner - (corner % 3), directions, fan)) directions[fan + 2] = 1;
  }
}
