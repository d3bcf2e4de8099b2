import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import { cornerLayout, formLayout, hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import type { VertexWords, Words } from '../../mesh/bake/vertexWords.js';

/** A vertex attribute of a geometry. */
export type VertexAttribute = BufferAttribute | InterleavedBufferAttribute;

/** An attribute that the prepared geometry keeps. */
export interface KeptAttribute {
  name: string;
  /** Whether it is a target of `morphAttributes[name]` instead of `attributes[name]`. */
  isMorphTarget: boolean;
  attribute: VertexAttribute;
}

/** The names of the attributes that the bake writes, also in the form that glTF gives to custom attributes. */
const bakedNames = /* @__PURE__ */ new Set<string>(
  /* @__PURE__ */ [...cornerLayout, hatchNormal, ...Object.values(formLayout)].flatMap(({ name }) => [
    name,
    `_${name.toLowerCase()}`,
  ]),
);

/** Whether the attribute has one entry per instance, not per vertex. */
export const isInstanced = (attribute: VertexAttribute): boolean =>
  'isInstancedBufferAttribute' in attribute ||
  ('data' in attribute && 'isInstancedInterleavedBuffer' in attribute.data);

/** All attributes per vertex, except the position and those that the bake writes, which a prepared geometry already has. */
export function keptAttributes(geometry: BufferGeometry): KeptAttribute[] {
  const kept: KeptAttribute[] = [];
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (name === 'position' || bakedNames.has(name) || isInstanced(attribute)) continue;
    kept.push({ name, isMorphTarget: false, attribute });
  }
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    for (const attribute of targets ?? []) kept.push({ name, isMorphTarget: true, attribute });
  }
  return kept;
}

/** Copies the first `count` entries of an attribute bit by bit, de-interleaved, as words of the size of its components. */
export function extractWords(attribute: VertexAttribute, count: number): VertexWords {
  const { itemSize } = attribute;
  const source = wordsOf(attribute.array);
  const perElement = source.length / attribute.array.length;
  const wordsPerVertex = itemSize * perElement;
  if (!('data' in attribute)) return { words: source.slice(0, count * wordsPerVertex), wordsPerVertex };

  const stride = attribute.data.stride * perElement;
  const offset = attribute.offset * perElement;
  const words = new (source.constructor as new (length: number) => Words)(count * wordsPerVertex);
  for (let vertex = 0; vertex < count; vertex++) {
    for (let i = 0; i < wordsPerVertex; i++) words[vertex * wordsPerVertex + i] = source[vertex * stride + offset + i];
  }
  return { words, wordsPerVertex };
}

/** A view of an array as words of the size of its components. Doubles become pairs of 32-bit words. */
function wordsOf(array: ArrayBufferView & { BYTES_PER_ELEMENT: number }): Words {
  const buffer = array.buffer as ArrayBuffer;
  if (array.BYTES_PER_ELEMENT === 1) return new Uint8Array(buffer, array.byteOffset, array.byteLength);
  if (array.BYTES_PER_ELEMENT === 2) return new Uint16Array(buffer, array.byteOffset, array.byteLength / 2);
  return new Uint32Array(buffer, array.byteOffset, array.byteLength / 4);
}
