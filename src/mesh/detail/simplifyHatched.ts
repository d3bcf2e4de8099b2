import { asPhase, forEachChunk } from '../phases.js';
import { simplifierOf } from './loadSimplifier.js';
import { type DetailLevels, makeLevels } from './makeLevels.js';
import type { SimplifiableMesh } from './simplifyTriangles.js';

/** A baked mesh to simplify. */
export interface DetailRequest extends HatchedVertices {
  indices: Uint32Array<ArrayBuffer>;
  /** Radius of the bounding sphere, in object units. */
  radius: number;
  /** The URL of meshoptimizer's simplifier. */
  simplifier: string;
}

/** Makes the levels of a baked mesh. The simplifier must be loaded. */
export function* simplifyHatched(request: DetailRequest): Generator<number, DetailLevels, void> {
  const { radius, indices } = request;
  const mesh = yield* asPhase(hatchedMesh(request, radius), 0, 0.05);
  return yield* asPhase(makeLevels(mesh, indices, radius, simplifierOf(request.simplifier)), 0.05, 1);
}

/**
 * How far a vertex may move, in radii of the mesh, for a turn of its strokes by one radian, for the whole of a map, for a whole colour, and
 * for one line along the form, which is the mean distance of two lines.
 */
const WEIGHTS = { normal: 0.02, uv: 0.5, color: 0.05, form: 1 / 16 };

/** The vertices of a baked mesh, as arrays. */
interface HatchedVertices {
  positions: Float32Array<ArrayBuffer>;
  /** Four 16-bit integers per vertex: the normal that orients strokes, then w. */
  hatchNormals: Int16Array<ArrayBuffer>;
  /** Two per vertex, if the mesh has a map. */
  uvs: Float32Array<ArrayBuffer> | null;
  /** Three or four per vertex, if its vertices have colours. */
  colors: Float32Array<ArrayBuffer> | null;
  /** φ and φ₂ of every vertex, if lines follow the form. */
  forms: Float32Array<ArrayBuffer> | null;
}

/** Collects the attributes that strokes depend on, so that simplified meshes keep them. */
export function* hatchedMesh(
  { positions, hatchNormals, uvs, colors, forms }: HatchedVertices,
  radius: number,
): Generator<number, SimplifiableMesh, void> {
  const count = positions.length / 3;
  const colorSize = colors ? colors.length / count : 0;
  const weights = [
    ...new Array<number>(3).fill(WEIGHTS.normal),
    ...new Array<number>(uvs ? 2 : 0).fill(WEIGHTS.uv),
    ...new Array<number>(colorSize).fill(WEIGHTS.color),
    ...new Array<number>(forms ? 2 : 0).fill(WEIGHTS.form),
  ].map((weight) => weight * radius);
  const attributes = new Float32Array(count * weights.length);
  yield* forEachChunk(count, (start, end) => {
    gather(attributes, weights.length, 0, hatchNormals, 4, 3, 1 / 32767, start, end);
    if (uvs) gather(attributes, weights.length, 3, uvs, 2, 2, 1, start, end);
    if (colors) gather(attributes, weights.length, uvs ? 5 : 3, colors, colorSize, colorSize, 1, start, end);
    if (forms) gather(attributes, weights.length, weights.length - 2, forms, 2, 2, 1, start, end);
  });
  return { positions, attributes, weights };
}

function gather(
  target: Float32Array,
  stride: number,
  offset: number,
  source: Float32Array | Int16Array,
  sourceStride: number,
  size: number,
  scale: number,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    for (let k = 0; k < size; k++) target[i * stride + offset + k] = source[i * sourceStride + k] * scale;
  }
}
