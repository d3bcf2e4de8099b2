import { vertexAcross } from '../corners.js';
import { asPhase, forEachChunk } from '../phases.js';
import { pullColumns, pullTextureSize, TRIANGLE_WORDS, VERTEX_WORDS } from './pullLayout.js';

/** The textures of the `pull` layout, padded to whole rows (`pullTextureSize`). */
export interface PackedPull {
  /** The number of texels in a row of either texture, if it has more than one row. */
  columns: number;
  /** `TRIANGLE_WORDS` words per triangle. */
  triangleVertices: Uint32Array<ArrayBuffer>;
  /** `VERTEX_WORDS` floats per vertex. */
  vertexPositions: Float32Array<ArrayBuffer>;
}

/** Writes the textures of the `pull` layout. `indices` refers to the vertices in `positions`. */
export function* packPull(
  positions: Float32Array,
  indices: Uint32Array,
  twins: Int32Array,
): Generator<number, PackedPull, void> {
  const triangleCount = indices.length / 3;
  const vertexCount = positions.length / 3;
  const columns = pullColumns(Math.max((triangleCount * TRIANGLE_WORDS) / 4, (vertexCount * VERTEX_WORDS) / 4));
  const packed = {
    columns,
    triangleVertices: new Uint32Array(paddedWords(triangleCount, TRIANGLE_WORDS, columns)),
    vertexPositions: new Float32Array(paddedWords(vertexCount, VERTEX_WORDS, columns)),
  };
  const isUsed = new Uint8Array(vertexCount);
  yield* asPhase(
    forEachChunk(triangleCount, (start, end) =>
      packTriangles(indices, twins, isUsed, packed.triangleVertices, start, end),
    ),
    0,
    0.7,
  );
  yield* asPhase(
    forEachChunk(vertexCount, (start, end) => packPositions(positions, packed.vertexPositions, start, end)),
    0.7,
    1,
  );
  return packed;
}

/** The number of words in a texture that holds `entries` entries, padding included. A texel has four words. */
export function paddedWords(entries: number, wordsPerEntry: number, columns?: number): number {
  const { width, height } = pullTextureSize((entries * wordsPerEntry) / 4, columns);
  return 4 * width * height;
}

function packTriangles(
  indices: Uint32Array,
  twins: Int32Array,
  isUsed: Uint8Array,
  words: Uint32Array,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const target = TRIANGLE_WORDS * triangle;
    for (let k = 0; k < 3; k++) {
      const corner = 3 * triangle + k;
      const vertex = indices[corner];
      words[target + k] = vertex;
      words[target + 4 + k] = vertexAcross(indices, twins, corner);
      if (isUsed[vertex]) continue;
      isUsed[vertex] = 1;
      words[target + 3] |= 1 << k;
    }
  }
}

function packPositions(positions: Float32Array, texels: Float32Array, start: number, end: number): void {
  for (let vertex = start; vertex < end; vertex++) {
    texels[VERTEX_WORDS * vertex] = positions[3 * vertex];
    texels[VERTEX_WORDS * vertex + 1] = positions[3 * vertex + 1];
    texels[VERTEX_WORDS * vertex + 2] = positions[3 * vertex + 2];
  }
}
