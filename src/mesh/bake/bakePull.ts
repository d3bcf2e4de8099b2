import { asPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import type { BakeRequest } from './bakeCorners.js';
import { type BakeReport, bakeSurface, reportOf } from './bakeSurface.js';
import {
  type CornerAttributes,
  cornerAttributeBuffers,
  expandPerCorner,
  packCornerAttributes,
} from './packCornerAttributes.js';
import { outlineBuffers } from './packOutlines.js';
import { type PackedPull, packPull } from './packPull.js';
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

/** The buffers of a result, which are transferred with it. */
export const bakePullResultBuffers = (result: BakePullResult): ArrayBuffer[] => [
  result.positions.buffer,
  result.triangleVertices.buffer,
  result.vertexPositions.buffer,
  ...cornerAttributeBuffers(result),
  ...outlineBuffers(result.outlines),
];
