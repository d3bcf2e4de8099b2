import { type BufferGeometry, DataUtils } from 'three';
import type { VertexWords } from '../bake/expandPerCorner.js';
import type { KeptAttribute, VertexAttribute } from './vertexAttributes.js';

/** What had to be repaired in the source. Part of `HatchingStatistics`. */
export interface Repairs {
  /** Vertices whose normal was computed: all if the source had none, else those in triangles where it was zero or not finite. */
  computedNormals: number;
  /**
   * Values of colours, texture coordinates, tangents, skin indices and weights and morph targets that were not finite. They became 0; in
   * morph targets that are not relative, the value of the unmorphed vertex.
   */
  zeroedValues: number;
}

/** The attributes that three's shaders read. Others are one's own and are kept as they are. */
const READ_BY_THREE = /^(color|uv\d?|tangent|skinIndex|skinWeight)$/;

/**
 * How many normals cannot be used: all if there are none, else those in `indices` that are zero or not finite. Scans have some
 * vertices without triangles, whose normals are zero. Computing them would lengthen the bake by a tenth, for nothing.
 */
export function countUnusableNormals({ attributes }: BufferGeometry, indices: Uint32Array): number {
  const { position, normal } = attributes;
  if (normal === undefined) return position.count;
  let unusable = 0;
  let isDrawn: Uint8Array | undefined;
  for (let vertex = 0; vertex < position.count; vertex++) {
    if (isUsable(normal, vertex)) continue;
    isDrawn ??= markDrawn(indices, position.count);
    unusable += isDrawn[vertex];
  }
  return unusable;
}

/** 1 for every vertex in `indices`. */
function markDrawn(indices: Uint32Array, vertexCount: number): Uint8Array {
  const isDrawn = new Uint8Array(vertexCount);
  for (let corner = 0; corner < indices.length; corner++) isDrawn[indices[corner]] = 1;
  return isDrawn;
}

/** Replaces the normals that cannot be used. */
export function replaceUnusableNormals(normal: VertexAttribute, computed: Float32Array): void {
  for (let vertex = 0; vertex < normal.count; vertex++) {
    if (isUsable(normal, vertex)) continue;
    normal.setXYZ(vertex, computed[3 * vertex], computed[3 * vertex + 1], computed[3 * vertex + 2]);
  }
}

function isUsable(normal: VertexAttribute, vertex: number): boolean {
  const x = normal.getX(vertex);
  const y = normal.getY(vertex);
  const z = normal.getZ(vertex);
  const square = x * x + y * y + z * z;
  return square > 0 && square < Infinity;
}

/** Repairs the copied values of an attribute in place. Returns how many were not finite. */
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

/** All ones in a half float that is infinite or not a number. */
const HALF_EXPONENT = 0x7c00;

/** The words as numbers, half floats as they are; null for integers, which are always finite. */
function valuesOf({ array }: VertexAttribute, words: VertexWords['words'], isHalf: boolean) {
  if (isHalf) return words;
  if (array instanceof Float32Array) return new Float32Array(words.buffer, words.byteOffset, words.length);
  if (array instanceof Float64Array) return new Float64Array(words.buffer, words.byteOffset, words.length / 2);
  return null;
}
