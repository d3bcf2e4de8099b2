import type { BufferGeometry } from 'three';
import { keptAttributes, type VertexAttribute } from './vertexAttributes.js';

/** Remembers the data of a geometry. Returns a function that tells whether the data is still the same. */
export function rememberSource(geometry: BufferGeometry): () => boolean {
  const before = stateOf(geometry);
  return () => {
    const now = stateOf(geometry);
    return now.length === before.length && now.every((entry, i) => entry === before[i]);
  };
}

/** All arrays that a bake reads, each followed by its version. */
const stateOf = (geometry: BufferGeometry): unknown[] =>
  [geometry.attributes.position, geometry.index, ...keptAttributes(geometry).map(({ attribute }) => attribute)].flatMap(
    (attribute) => (attribute ? [attribute.array, versionOf(attribute)] : [null]),
  );

const versionOf = (attribute: VertexAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;
