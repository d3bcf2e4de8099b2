import { asPhase } from '../phases.js';
import { type BakeReport, bakeSurface, reportOf, type SurfaceRequest } from './bakeSurface.js';
import { type PackedForm, packForm, packHatchNormals, packNormals } from './packAttributes.js';
import { splitVertices } from './splitVertices.js';

/** The result of `bakeIndexed`. Plain data: the worker posts it back. */
export interface BakeIndexedResult extends BakeReport {
  /** The vertex of each corner, added vertices included, in 16 bits if they suffice. */
  indices: Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
  /** For each added vertex, the vertex it copies. Added vertices follow those of the mesh. */
  addedVertices: Uint32Array<ArrayBuffer>;
  /** Each vertex's `hatchNormal`. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** x, y, z of each vertex's smooth normal, if requested. */
  normals: Float32Array<ArrayBuffer> | null;
  /** Each vertex's attributes of lines that follow the form, if requested. */
  form: PackedForm | null;
}

/** The largest number of vertices for 16-bit indices: index 65535 would restart primitives. */
const MAX_SHORT_VERTICES = 0xffff;

/**
 * Bakes the `indexed` layout: the vertices as they are, a `hatchNormal` and, on request, form values for each, and copies of the vertices
 * that need more than one. Other attributes are not part of the request: the caller appends copies of the entries that `addedVertices`
 * names. It is pure, and throws as `bakeCorners` does.
 */
export function* bakeIndexed(request: SurfaceRequest): Generator<number, BakeIndexedResult, void> {
  const surface = yield* asPhase(bakeSurface(request, false), 0, 0.85);
  const { hatchNormals, smoothNormals, adjacency, form } = surface;
  const splitting = splitVertices(request.mesh, adjacency.areaNormals, hatchNormals.fans, form?.ofCorner);
  const split = yield* asPhase(splitting, 0.85, 0.95);
  const { indices, addedVertices, cornerOfVertex } = split;
  return {
    ...(yield* asPhase(reportOf(surface, indices), 0.95, 0.97)),
    indices: cornerOfVertex.length <= MAX_SHORT_VERTICES ? new Uint16Array(indices) : indices,
    addedVertices,
    normals: smoothNormals && (yield* asPhase(packNormals(smoothNormals, cornerOfVertex), 0.97, 0.98)),
    form: form && (yield* asPhase(packForm(form, form.radius, cornerOfVertex), 0.98, 0.99)),
    hatchNormals: yield* asPhase(packHatchNormals(hatchNormals, cornerOfVertex), 0.99, 1),
  };
}
