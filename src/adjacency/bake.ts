import { type BakeReport, bakeSurface, reportOf, type SurfaceRequest } from './bakeSurface.js';
import { expandPerCorner, type VertexWords, type Words } from './expandPerCorner.js';
import { packHatchNormals } from './hatchNormal.js';
import { asPhase } from './inChunks.js';
import { type PackedCorners, packCorners } from './packCorners.js';
import { packNormals } from './packNormals.js';

/** What the bake of the `corner` layout is asked to do. Plain data: it travels to the worker. */
export interface BakeRequest extends SurfaceRequest {
  /** Attributes to copy from vertices to corners. */
  attributes: VertexWords[];
}

/** What the bake of the `corner` layout returns. Plain data: it travels back from the worker. */
export interface BakeResult extends PackedCorners, BakeReport {
  /** Each corner's `hatchNormal`. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** x, y, z of each corner's smooth normal, if asked for. */
  normals: Float32Array<ArrayBuffer> | null;
  /** The attributes of the request, in its order, one entry per corner. */
  attributes: Words[];
}

/**
 * Bakes triangle adjacency into the `corner` layout: weld, pair the edges, cut the creases, smooth the normals, pack.
 * Throws a RangeError for a mesh that cannot be baked; see `validateTriangleMesh`. Pure: the same request gives the same
 * bytes everywhere.
 */
export function* bake(request: BakeRequest): Generator<number, BakeResult, void> {
  const { mesh } = request;
  const surface = yield* asPhase(bakeSurface(request), 0, 0.7);
  const { hatchNormals, smoothNormals } = surface;
  const packed = yield* asPhase(packCorners(mesh, surface.adjacency.twins), 0.7, 0.85);
  const packedHatchNormals = yield* asPhase(packHatchNormals(hatchNormals, null), 0.85, 0.88);
  const normals = smoothNormals && (yield* asPhase(packNormals(smoothNormals, null), 0.88, 0.9));

  const attributes: Words[] = [];
  const share = 0.1 / Math.max(1, request.attributes.length);
  for (const [i, attribute] of request.attributes.entries()) {
    const from = 0.9 + i * share;
    attributes.push(yield* asPhase(expandPerCorner(attribute, mesh.indices), from, from + share));
  }
  return { ...packed, ...reportOf(surface), hatchNormals: packedHatchNormals, normals, attributes };
}

/** The buffers of a request, to be transferred with it. */
export const bakeRequestBuffers = ({ mesh, attributes }: BakeRequest): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];

/** The buffers of a result, to be transferred with it. */
export const bakeResultBuffers = ({
  positions,
  corners,
  hatchNormals,
  normals,
  attributes,
}: BakeResult): ArrayBuffer[] => [
  positions.buffer,
  corners.buffer,
  hatchNormals.buffer,
  ...(normals ? [normals.buffer] : []),
  ...attributes.map((words) => words.buffer),
];
