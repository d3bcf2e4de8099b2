import type { BufferGeometry } from 'three';
import { keptAttributes, type VertexAttribute } from './vertexAttributes.js';

/** Remembers what a geometry holds. Returns a function that tells whether it still holds the same. */
export function rememberSource(geometry: BufferGeometry): () => boolean {
  const before = stateOf(geometry);
  return () => {
    const now = stateOf(geometry);
    return now.length === before.length && now.every((one, i) => one === before[i]);
  };
}

/** Every array that a bake reads, with its version. */
const stateOf = (geometry: BufferGeometry): unknown[] =>
  [geometry.attributes.position, geometry.index, ...keptAttributes(geometry).map(({ attribute }) => attribute)].flatMap(
    (attribute) => (attribute ? [attribute.array, versionOf(attribute)] : [null]),
  );

const versionOf = (attribute: VertexAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;
