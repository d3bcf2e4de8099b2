import { vertexAcross } from '../corners.js';
import { asPhase, chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { type BakeRequest, type CornerAttributes, expandPerCorner, packCornerAttributes } from './bakeCorners.js';
import { type BakeReport, bakeSurface, reportOf } from './bakeSurface.js';
import { paddedWords, pullColumns, TRIANGLE_WORDS, VERTEX_WORDS } from './pullLayout.js';
import { splitVertices } from './splitVertices.js';
import { appendVertices } from './vertexWords.js';

/** The result of `bakePull`. Plain data: the worker posts it back. */
export interface BakePullResult extends PackedPull, CornerAttributes, BakeReport {
  /** x, y, z of each corner. */
  positions: Float32Array<ArrayBuffer>;
}

/** Bakes triangle adjacency into the `pull` layout (`pullLayout.ts`). It is pure, and throws as `bakeCorners` does. */
export function* bakePull(request: BakeRequest): Generator<number, BakePullResult, void> {
  const { mesh, attributes } = request;
  const surface = yield* asPhase(bakeSurface(request, true), 0, 0.7);
  const { adjacency, smoothNormals } = surface;
  let { positions, indices }: TriangleMesh = mesh;
  if (smoothNormals) {
    // A vertex at a crease has several smooth normals. It is split, so that each vertex has only one.
    const split = yield* asPhase(splitVertices(mesh, adjacency.areaNormals, smoothNormals.fans), 0.7, 0.75);
    const words = { words: new Uint32Array(positions.buffer), wordsPerVertex: 3 };
    positions = new Float32Array(appendVertices(words, split.addedVertices).buffer);
    indices = split.indices;
  }
  const packed = yield* asPhase(packPull(positions, indices, adjacency.twins), 0.75, 0.82);
  const words = new Uint32Array(mesh.positions.buffer);
  const expanded = yield* asPhase(expandPerCorner({ words, wordsPerVertex: 3 }, mesh.indices), 0.82, 0.85);
  const ofCorners = yield* asPhase(packCornerAttributes(surface, mesh.indices, attributes), 0.85, 0.97);
  const report = yield* asPhase(reportOf(surface, indices), 0.97, 1);
  return { ...packed, ...report, ...ofCorners, positions: new Float32Array(expanded.buffer) };
}

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
  yield* chunkPhase(triangleCount, 0, 0.7, (start, end) =>
    packTriangles(indices, twins, isUsed, packed.triangleVertices, start, end),
  );
  yield* chunkPhase(vertexCount, 0.7, 1, (start, end) => packPositions(positions, packed.vertexPositions, start, end));
  return packed;
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
