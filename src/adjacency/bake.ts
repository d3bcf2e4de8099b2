import { buildTriangleAdjacency } from './buildTriangleAdjacency.js';
import { computeSmoothNormals } from './computeSmoothNormals.js';
import { cutCreases } from './cutCreases.js';
import type { EdgeCounts } from './EdgeCounts.js';
import { expandPerCorner, type VertexWords, type Words } from './expandPerCorner.js';
import { asPhase } from './inChunks.js';
import { type Bounds, measureBounds } from './measureBounds.js';
import { type PackedCorners, packCorners } from './packCorners.js';
import type { TriangleMesh } from './TriangleMesh.js';
import { validateTriangleMesh } from './validateTriangleMesh.js';

/** What the bake is asked to do. Plain data: it travels to the worker. */
export interface BakeRequest {
  /** Opens every error message: the function that was called and the thing it was given. */
  label: string;
  mesh: TriangleMesh;
  /** Edges whose triangles' normals differ by more than this, in radians, get no neighbour. */
  creaseAngle: number;
  /** Whether to compute smooth normals, for a mesh that has none. */
  wantsNormals: boolean;
  /** Attributes to copy from vertices to corners. */
  attributes: VertexWords[];
}

/** What the bake returns. Plain data: it travels back from the worker. */
export interface BakeResult extends PackedCorners, EdgeCounts {
  /** x, y, z of each corner's smooth normal, if asked for. */
  normals: Float32Array<ArrayBuffer> | null;
  /** The attributes of the request, in its order, one entry per corner. */
  attributes: Words[];
  bounds: Bounds;
}

/**
 * Bakes triangle adjacency into the `corner` layout: weld, pair the edges, cut the creases, pack. Throws a RangeError
 * for a mesh that cannot be baked; see `validateTriangleMesh`. Pure: the same request gives the same bytes everywhere.
 */
export function* bake(request: BakeRequest): Generator<number, BakeResult, void> {
  const { mesh } = request;
  yield* asPhase(validateTriangleMesh(mesh, request.label), 0, 0.05);
  const adjacency = yield* asPhase(buildTriangleAdjacency(mesh), 0.05, 0.5);
  yield* asPhase(cutCreases(adjacency, request.creaseAngle), 0.5, 0.55);
  const normals = request.wantsNormals ? yield* asPhase(computeSmoothNormals(adjacency), 0.55, 0.65) : null;
  const packed = yield* asPhase(packCorners(mesh, adjacency.twins), 0.65, 0.85);
  const bounds = yield* asPhase(measureBounds(packed.positions), 0.85, 0.9);

  const attributes: Words[] = [];
  const share = 0.1 / Math.max(1, request.attributes.length);
  for (const [i, attribute] of request.attributes.entries()) {
    const from = 0.9 + i * share;
    attributes.push(yield* asPhase(expandPerCorner(attribute, mesh.indices), from, from + share));
  }

  const { borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles } = adjacency;
  return {
    ...packed,
    normals,
    attributes,
    bounds,
    borderEdges,
    nonManifoldEdges,
    inconsistentEdges,
    degenerateTriangles,
  };
}

/** The buffers of a request, to be transferred with it. */
export const bakeRequestBuffers = ({ mesh, attributes }: BakeRequest): ArrayBuffer[] => [
  mesh.positions.buffer,
  mesh.indices.buffer,
  ...attributes.map(({ words }) => words.buffer),
];

/** The buffers of a result, to be transferred with it. */
export const bakeResultBuffers = ({ positions, corners, normals, attributes }: BakeResult): ArrayBuffer[] => [
  positions.buffer,
  corners.buffer,
  ...(normals ? [normals.buffer] : []),
  ...attributes.map((words) => words.buffer),
];
