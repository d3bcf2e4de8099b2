import { readOctahedral } from './octahedral.js';
import { POINT_WORDS } from './outlineLayout.js';

/** Unpacks the positions and unit normals of the first `count` points that `packOutlines` has written. */
export function unpackPoints(
  words: Uint32Array<ArrayBuffer>,
  count: number,
): { positions: Float32Array<ArrayBuffer>; normals: Float32Array<ArrayBuffer> } {
  const floats = new Float32Array(words.buffer);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  for (let point = 0; point < count; point++) {
    const source = POINT_WORDS * point;
    positions[3 * point] = floats[source];
    positions[3 * point + 1] = floats[source + 1];
    positions[3 * point + 2] = floats[source + 2];
    readOctahedral(words[source + 3], normals, 3 * point);
  }
  return { positions, normals };
}
