import { vertexAcross } from '../corners.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { CORNER_STRIDE } from './attributeLayouts.js';
import { type BakeReport, bakeSurface, reportOf, type Surface, type SurfaceRequest } from './bakeSurface.js';
import { type PackedForm, packForm, packHatchNormals, packNormals } from './packAttributes.js';
import type { VertexWords, Words } from './vertexWords.js';

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

/** The vertex attributes of layouts with three vertices per triangle. */
export interface CornerAttributes {
  /** Each corner's `hatchNormal`. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** x, y, z of each corner's smooth normal, if requested. */
  normals: Float32Array<ArrayBuffer> | null;
  /** Each corner's attributes of lines that follow the form, if requested. */
  form: PackedForm | null;
  /** The attributes of the request, in the same order, with one entry per corner. */
  attributes: Words[];
}

/** Writes the normals of each corner and copies `attributes` from the vertices that `indices` names. */
export function* packCornerAttributes(
  { hatchNormals, smoothNormals, form }: Surface,
  indices: Uint32Array,
  attributes: readonly VertexWords[],
): Generator<number, CornerAttributes, void> {
  const packedHatchNormals = yield* asPhase(packHatchNormals(hatchNormals, null), 0, 0.2);
  const normals = smoothNormals && (yield* asPhase(packNormals(smoothNormals, null), 0.2, 0.3));
  const packedForm = form && (yield* asPhase(packForm(form, form.radius, null), 0.3, 0.4));
  const expanded: Words[] = [];
  const share = 0.6 / Math.max(1, attributes.length);
  for (const [i, attribute] of attributes.entries()) {
    const from = 0.4 + i * share;
    expanded.push(yield* asPhase(expandPerCorner(attribute, indices), from, from + share));
  }
  return { hatchNormals: packedHatchNormals, normals, form: packedForm, attributes: expanded };
}

/** Copies the words of each corner's vertex to the corner. */
export function* expandPerCorner(source: VertexWords, indices: Uint32Array): Generator<number, Words, void> {
  const { words, wordsPerVertex } = source;
  const expanded = new (words.constructor as new (length: number) => Words)(indices.length * wordsPerVertex);
  yield* forEachChunk(indices.length, (start, end) => expandRange(source, indices, expanded, start, end));
  return expanded;
}

function expandRange(
  { words, wordsPerVertex }: VertexWords,
  indices: Uint32Array,
  expanded: Words,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const from = indices[corner] * wordsPerVertex;
    const to = corner * wordsPerVertex;
    for (let i = 0; i < wordsPerVertex; i++) expanded[to + i] = words[from + i];
  }
}

/** The vertex buffers of the `corner` layout. */
interface PackedCorners {
  /** x, y, z of each corner. */
  positions: Float32Array<ArrayBuffer>;
  /** `CORNER_STRIDE` floats per corner, in the order of `cornerLayout`. */
  corners: Float32Array<ArrayBuffer>;
}

/** Writes the `corner` layout: for every corner the positions of the six adjacency vertices of its triangle. */
export function* packCorners(mesh: TriangleMesh, twins: Int32Array): Generator<number, PackedCorners, void> {
  const cornerCount = mesh.indices.length;
  const packed = {
    positions: new Float32Array(3 * cornerCount),
    corners: new Float32Array(CORNER_STRIDE * cornerCount),
  };
  yield* forEachChunk(cornerCount / 3, (start, end) => packRange(mesh, twins, packed, start, end));
  return packed;
}

function packRange(
  { positions: vertices, indices }: TriangleMesh,
  twins: Int32Array,
  { positions, corners }: PackedCorners,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const alpha = vertexAcross(indices, twins, first);
    const beta = vertexAcross(indices, twins, first + 1);
    const gamma = vertexAcross(indices, twins, first + 2);
    let own = indices[first];
    let next = indices[first + 1];
    let previous = indices[first + 2];
    for (let k = 0; k < 3; k++) {
      const target = CORNER_STRIDE * (first + k);
      copyPosition(vertices, own, positions, 3 * (first + k));
      copyPosition(vertices, next, corners, target);
      corners[target + 3] = k;
      copyPosition(vertices, previous, corners, target + 4);
      copyPosition(vertices, alpha, corners, target + 7);
      copyPosition(vertices, beta, corners, target + 10);
      copyPosition(vertices, gamma, corners, target + 13);
      const rotated = own;
      own = next;
      next = previous;
      previous = rotated;
    }
  }
}

function copyPosition(vertices: Float32Array, vertex: number, target: Float32Array, offset: number): void {
  target[offset] = vertices[3 * vertex];
  target[offset + 1] = vertices[3 * vertex + 1];
  target[offset + 2] = vertices[3 * vertex + 2];
}
