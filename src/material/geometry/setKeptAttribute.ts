import { BufferAttribute, type BufferGeometry, Float16BufferAttribute } from 'three';
import type { Words } from '../../mesh/bake/expandPerCorner.js';
import type { KeptAttribute, VertexAttribute } from './vertexAttributes.js';

/** Adds the attribute where it was in the source: to the attributes, or to the end of the morph targets of its name. */
export function setKeptAttribute(
  geometry: BufferGeometry,
  { name, isMorphTarget, attribute }: KeptAttribute,
  words: Words,
): void {
  const copy = attributeFromWords(attribute, words);
  if (!isMorphTarget) geometry.setAttribute(name, copy);
  else {
    const morphs = geometry.morphAttributes as Record<string, BufferAttribute[]>;
    morphs[name] = [...(morphs[name] ?? []), copy];
  }
}

/** Creates an attribute from words, with the type, normalisation and GPU type of `source`. */
function attributeFromWords(source: VertexAttribute, words: Words): BufferAttribute {
  const { itemSize, normalized } = source;
  const ArrayType = source.array.constructor as new (buffer: ArrayBuffer) => Float32Array;
  const array = new ArrayType(words.buffer);
  // three.js recognises half floats by the class of the attribute. Its constructor uses a buffer without copying it.
  const attribute =
    'isFloat16BufferAttribute' in source
      ? new Float16BufferAttribute(words.buffer as unknown as ArrayLike<number>, itemSize, normalized)
      : new BufferAttribute(array, itemSize, normalized);
  attribute.name = source.name;
  if ('gpuType' in source) attribute.gpuType = source.gpuType;
  return attribute;
}
