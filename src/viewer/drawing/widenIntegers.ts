import { BufferAttribute, type InterleavedBufferAttribute, type Object3D } from 'three';
import { meshesOf } from './meshesOf.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/**
 * What three's renderer of nodes rewrites in place when it uploads it, as integers of 32 bits, which WebGLRenderer cannot draw any more.
 * Those per instance no material of the page reads.
 */
const isRewritten = (attribute: Attribute): boolean =>
  !attribute.normalized && attribute.array.BYTES_PER_ELEMENT < 4 && !('isInstancedBufferAttribute' in attribute);

/** Gives all meshes of a scene floats in place of narrow integers, such as the numbers of bones, so that both renderers can draw them. */
export function widenIntegers(root: Object3D): void {
  // Parts of a file often share attributes.
  const floats = new Map<Attribute, BufferAttribute>();
  for (const { geometry } of meshesOf(root)) {
    for (const [name, attribute] of Object.entries(geometry.attributes)) {
      if (!isRewritten(attribute)) continue;
      const wide = floats.get(attribute) ?? asFloats(attribute);
      floats.set(attribute, wide);
      geometry.setAttribute(name, wide);
    }
  }
}

function asFloats(attribute: Attribute): BufferAttribute {
  const { count, itemSize, name } = attribute;
  const values = new Float32Array(count * itemSize);
  for (let i = 0; i < values.length; i++) values[i] = attribute.getComponent(Math.floor(i / itemSize), i % itemSize);
  const floats = new BufferAttribute(values, itemSize);
  floats.name = name;
  return floats;
}
