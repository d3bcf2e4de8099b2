import type { FanNormals } from '../normals/fanNormals.js';
import { forEachChunk } from '../phases.js';
import { hatchNormal } from './attributeLayouts.js';
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
