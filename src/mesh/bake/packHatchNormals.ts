import type { FanNormals } from '../normals/FanNormals.js';
import { forEachChunk } from '../timeSlicing/forEachChunk.js';
import { hatchNormal } from './hatchNormal.js';
import { NO_CORNER } from './splitVertices.js';

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

/** Packs the `hatchNormal` attribute, per vertex or per corner as `packNormals` does. */
export function* packHatchNormals(
  { fans, normals }: FanNormals,
  cornerOfVertex: Uint32Array | null,
): Generator<number, Int16Array<ArrayBuffer>, void> {
  const count = (cornerOfVertex ?? fans.ofCorner).length;
  const packed = new Int16Array(hatchNormal.itemSize * count);
  yield* forEachChunk(count, (start, end) => quantizeRange(normals, fans.ofCorner, cornerOfVertex, packed, start, end));
  return packed;
}

function quantizeRange(
  normals: Float32Array,
  ofCorner: Uint32Array,
  cornerOfVertex: Uint32Array | null,
  packed: Int16Array,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const corner = cornerOfVertex ? cornerOfVertex[vertex] : vertex;
    if (corner === NO_CORNER) {
      packed[4 * vertex + 2] = ONE;
      continue;
    }
    const fan = 3 * ofCorner[corner];
    packed[4 * vertex] = Math.round(ONE * normals[fan]);
    packed[4 * vertex + 1] = Math.round(ONE * normals[fan + 1]);
    packed[4 * vertex + 2] = Math.round(ONE * normals[fan + 2]);
  }
}
