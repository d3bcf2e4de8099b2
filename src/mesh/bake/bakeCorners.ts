import { asPhase } from '../phases.js';
import { type BakeReport, bakeSurface, reportOf, type SurfaceRequest } from './bakeSurface.js';
import { type CornerAttributes, cornerAttributeBuffers, packCornerAttributes } from './packCornerAttributes.js';
import { type PackedCorners, packCorners } from './packCorners.js';
import { outlineBuffers } from './packOutlines.js';
import type { VertexWords } from './vertexWords.js';

/** The input of the bakes that give each corner a vertex of its own. Plain data: it is posted to the worker. */
export interface BakeRequest extends SurfaceRequest {
  /** Attributes to copy from vertices to corners. */
  attributes: VertexWords[];
}

/** The result of `bakeCorners`. Plain data: the worker posts it back. */
export interface BakeCornersResult extends PackedCorners, CornerAttributes, BakeReport {}

/**
 * Bakes triangle adjacency into the `corner` layout (`attributeLayouts.ts`): welds the vertices, pairs the edges, cuts the
 * creases, smooths the normals and packs the attributes. Throws a RangeError for a mesh that cannot be baked; see
 * `validateTriangleMesh`. It is pure: the same request gives the same bytes on every machine.
 */
export function* bakeCorners(request: BakeRequest): Generator<number, BakeCornersResult, void> {
  const { mesh, attributes } = request;
  const surface = yield* asPhase(bakeSurface(request, true), 0, 0.7);
  const packed = yield* asPhase(packCorners(mesh, surface.adjacency.twins), 0.7, 0.85);
  const ofCorners = yield* asPhase(packCornerAttributes(surface, mesh.indices, attributes), 0.85, 0.97);
  return { ...packed, ...(yield* asPhase(reportOf(surface, mesh.indices), 0.97, 1)), ...ofCorners };
}

/** The buffers of a result, which are transferred with it. */
export const bakeCornersResultBuffers = (result: BakeCornersResult): ArrayBuffer[] => [
  result.positions.buffer,
  result.corners.buffer,
  ...cornerAttributeBuffers(result),
  ...outlineBuffers(result.outlines),
];
