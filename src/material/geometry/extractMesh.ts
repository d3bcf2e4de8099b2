import type { BufferGeometry } from 'three';
import type { TriangleMesh } from '../../mesh/TriangleMesh.js';
import type { CornerRange } from './cornerRange.js';
import type { VertexAttribute } from './vertexAttributes.js';

/**
 * Copies the triangles of `range` out of a geometry. Positions become de-interleaved floats, as the vertex shader would read them.
 * Indices become 32-bit integers, consecutive ones if there is no index.
 */
export function extractMesh(geometry: BufferGeometry, range: CornerRange): TriangleMesh {
  const position = geometry.attributes.position;
  return { positions: copyVectors(position), indices: copyIndices(geometry, range) };
}

/** x, y, z of every entry, as the vertex shader would read them. */
export function copyVectors(attribute: VertexAttribute): Float32Array<ArrayBuffer> {
  const length = 3 * attribute.count;
  if (!('data' in attribute) && attribute.array instanceof Float32Array && attribute.itemSize === 3) {
    return new Float32Array(attribute.array.subarray(0, length));
  }
  const vectors = new Float32Array(length);
  for (let vertex = 0; vertex < attribute.count; vertex++) {
    vectors[3 * vertex] = attribute.getX(vertex);
    vectors[3 * vertex + 1] = attribute.getY(vertex);
    vectors[3 * vertex + 2] = attribute.itemSize > 2 ? attribute.getZ(vertex) : 0;
  }
  return vectors;
}

function copyIndices({ index }: BufferGeometry, { start, count }: CornerRange): Uint32Array<ArrayBuffer> {
  // Negative entries of a signed index become large numbers, which are out of range too.
  if (index) return new Uint32Array(index.array.subarray(start, start + count));
  const indices = new Uint32Array(count);
  for (let corner = 0; corner < count; corner++) indices[corner] = start + corner;
  return indices;
}
