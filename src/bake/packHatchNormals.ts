import type { FanNormals } from '../normals/FanNormals.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { hatchNormal } from './hatchNormal.js';
import { packNormals } from './packNormals.js';

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

/** Packs the `hatchNormal` attribute, per vertex or per corner as `packNormals` does. */
export function* packHatchNormals(
  hatchNormals: FanNormals,
  cornerOfVertex: Uint32Array | null,
): Generator<number, Int16Array<ArrayBuffer>, void> {
  const normals = yield* asPhase(packNormals(hatchNormals, cornerOfVertex), 0, 0.5);
  const count = normals.length / 3;
  const packed = new Int16Array(hatchNormal.itemSize * count);
  yield* asPhase(
    forEachChunk(count, (start, end) => quantizeRange(normals, packed, start, end)),
    0.5,
    1,
  );
  return packed;
}

function quantizeRange(normals: Float32Array, packed: Int16Array, start: number, end: number): void {
  for (let vertex = start; vertex < end; vertex++) {
    packed[4 * vertex] = Math.round(ONE * normals[3 * vertex]);
    packed[4 * vertex + 1] = Math.round(ONE * normals[3 * vertex + 1]);
    packed[4 * vertex + 2] = Math.round(ONE * normals[3 * vertex + 2]);
  }
}
