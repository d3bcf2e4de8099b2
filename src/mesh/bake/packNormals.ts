import type { FanNormals } from '../normals/FanNormals.js';
import { forEachChunk } from '../timeSlicing/forEachChunk.js';
import { NO_CORNER } from './splitVertices.js';

/**
 * Packs the normals of fans into an attribute of three floats. With `cornerOfVertex` it has one normal per vertex: that of its
 * corner's fan, or +z for NO_CORNER. With null it has one normal per corner.
 */
export function* packNormals(
  { fans, normals }: FanNormals,
  cornerOfVertex: Uint32Array | null,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const corners = cornerOfVertex ?? fans.ofCorner;
  const packed = new Float32Array(3 * corners.length);
  yield* forEachChunk(corners.length, (start, end) =>
    packRange(normals, fans.ofCorner, cornerOfVertex, packed, start, end),
  );
  return packed;
}

function packRange(
  normals: Float32Array,
  ofCorner: Uint32Array,
  cornerOfVertex: Uint32Array | null,
  packed: Float32Array,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const corner = cornerOfVertex ? cornerOfVertex[vertex] : vertex;
    if (corner === NO_CORNER) {
      packed[3 * vertex + 2] = 1;
      continue;
    }
    const fan = 3 * ofCorner[corner];
    packed[3 * vertex] = normals[fan];
    packed[3 * vertex + 1] = normals[fan + 1];
    packed[3 * vertex + 2] = normals[fan + 2];
  }
}
