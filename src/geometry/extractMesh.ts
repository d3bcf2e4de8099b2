import type { BufferGeometry } from 'three';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import type { CornerRange } from './cornerRange.js';
import type { VertexAttribute } from './vertexAttributes.js';

/**
 * Copies the triangles of `range` out of a geometry. Positions become de-interleaved floats, exactly as the vertex shader would
 * see them. Indices become 32-bit integers, consecutive ones if there is no index.
 */
export function extractMesh(geometry: BufferGeometry, range: CornerRange): TriangleMesh {
  const position = geometry.attributes.position;
  return { positions: copyPositions(position), indices: copyIndices(geometry, range) };
}

function copyPositions(position: VertexAttribute): Float32Array<ArrayBuffer> {
  const length = 3 * position.count;
  if (!('data' in position) && position.array instanceof Float32Array && position.itemSize === 3) {
    return new Float32Array(position.array.subarray(0, length));
  }
  const positions = new Float32Array(length);
  for (let vertex = 0; vertex < position.count; vertex++) {
    positions[3 * vertex] = position.getX(vertex);
    positions[3 * vertex + 1] = position.getY(vertex);
    positions[3 * vertex + 2] = position.itemSize > 2 ? position.getZ(vertex) : 0;
  }
  return positions;
}

function copyIndices({ index }: BufferGeometry, { start, count }: CornerRange): Uint32Array<ArrayBuffer> {
  // Negative entries of a signed index become large numbers, which are out of range as well.
  if (index) return new Uint32Array(index.array.subarray(start, start + count));
  const indices = new Uint32Array(count);
  for (let corner = 0; corner < count; corner++) indices[corner] = start + corner;
  return indices;
}
