import { type BufferGeometry, DataUtils } from 'three';
import type { VertexWords } from '../../mesh/bake/vertexWords.js';
import type { KeptAttribute, VertexAttribute } from './vertexAttributes.js';

/** Counts the repairs of the source. Part of `HatchingStatistics`. */
export interface Repairs {
  /**
   * The number of vertices whose normal was computed: all of them if the source had no normals, otherwise those vertices in
   * triangles whose normal was zero or not finite.
   */
  computedNormals: number;
  /**
   * The number of values of colours, texture coordinates, tangents, skin indices, skin weights and morph targets that were not
   * finite. They became 0; in morph targets that are not relative they became the value of the unmorphed vertex.
   */
  zeroedValues: number;
  /** The number of triangles that were turned, with `orient`. */
  turnedTriangles: number;
}

/** The attributes that the shaders of three.js read. All others are kept as they are. */
const READ_BY_THREE = /^(color|uv\d?|tangent|skinIndex|skinWeight)$/;

/**
 * Counts the normals that cannot be used: all if there are none, otherwise those that are zero or not finite at a vertex in `indices`.
 * Scans have vertices without triangles, whose normals are zero; to compute normals for these would be useless, and would lengthen the
 * bake by a tenth.
 */
export function countUnusableNormals({ attributes }: BufferGeometry, indices: Uint32Array): number {
  const { position, normal } = attributes;
  if (normal === undefined) return position.count;
  let unusable = 0;
  let isDrawn: Uint8Array | undefined;
  for (let vertex = 0; vertex < position.count; vertex++) {
    if (isUsableNormal(normal, vertex)) continue;
    isDrawn ??= markDrawn(indices, position.count);
    unusable += isDrawn[vertex];
  }
  return unusable;
}

/** Returns an array with 1 for every vertex in `indices`, and 0 for the others. */
function markDrawn(indices: Uint32Array, vertexCount: number): Uint8Array {
  const isDrawn = new Uint8Array(vertexCount);
  for (let corner = 0; corner < indices.length; corner++) isDrawn[indices[corner]] = 1;
  return isDrawn;
}

/** Whether a normal can be used as it is. */
export function isUsableNormal(normal: VertexAttribute, vertex: number): boolean {
  const x = normal.getX(vertex);
  const y = normal.getY(vertex);
  const z = normal.getZ(vertex);
  const square = x * x + y * y + z * z;
  return square > 0 && square < Infinity;
}

/** Repairs the copied values of an attribute in place. Returns the number of values that were not finite. */
export function zeroBadValues(
  geometry: BufferGeometry,
  kept: KeptAttribute,
  { words, wordsPerVertex }: VertexWords,
): number {
  const { name, isMorphTarget, attribute } = kept;
  if (!isMorphTarget && !READ_BY_THREE.test(name)) return 0;
  const isHalf = 'isFloat16BufferAttribute' in attribute;
  const values = valuesOf(attribute, words, isHalf);
  if (values === null) return 0;
  const base = isMorphTarget && !geometry.morphTargetsRelative ? geometry.attributes[name] : undefined;
  const perVertex = (wordsPerVertex * values.length) / words.length;
  let count = 0;
  for (let i = 0; i < values.length; i++) {
    if (isHalf ? (values[i] & HALF_EXPONENT) !== HALF_EXPONENT : values[i] - values[i] === 0) continue;
    count++;
    const rest = base?.getComponent(Math.floor(i / perVertex), i % perVertex) ?? 0;
    const value = Number.isFinite(rest) ? rest : 0;
    values[i] = isHalf ? DataUtils.toHalfFloat(value) : value;
  }
  return count;
}

/** The bits of a half float that are all set if it is infinite or NaN. */
const HALF_EXPONENT = 0x7c00;

/** The words as numbers, except that half floats stay words. Returns null for integers, which are always finite. */
function valuesOf({ array }: VertexAttribute, words: VertexWords['words'], isHalf: boolean) {
  if (isHalf) return words;
  if (array instanceof Float32Array) return new Float32Array(words.buffer, words.byteOffset, words.length);
  if (array instanceof Float64Array) return new Float64Array(words.buffer, words.byteOffset, words.length / 2);
  return null;
}
