import type { BufferGeometry } from 'three';
import type { TriangleMesh } from '../../mesh/TriangleMesh.js';
import type { VertexAttribute } from './vertexAttributes.js';

/** A group of a prepared geometry. `start` and `count` are in corners. */
export interface CornerGroup {
  start: number;
  count: number;
  materialIndex: number | undefined;
}

/** The drawn part of a geometry, and its groups relative to that part. All counts are multiples of three. */
export interface CornerRange {
  /** The first entry of the index, or the first vertex if there is no index. */
  start: number;
  count: number;
  groups: CornerGroup[];
}

/**
 * The draw range and the groups of a geometry, in corners, as three.js would draw them.
 *
 * @throws RangeError if a range starts or ends inside a triangle
 */
export function cornerRange(geometry: BufferGeometry, label: string): CornerRange {
  const unit = geometry.index ? 'index' : 'vertex';
  const available = geometry.index ? geometry.index.count : geometry.attributes.position.count;
  const start = Math.max(0, geometry.drawRange.start);
  const end = Math.min(available, geometry.drawRange.start + geometry.drawRange.count);
  const count = Math.max(0, end - start);
  if (count % 3 !== 0) {
    throw new RangeError(
      `${label}: the ${unit} count is ${count}, which is not a multiple of three. Remove the incomplete last triangle, or convert strips, fans and outlines to triangles first.`,
    );
  }
  const groups: CornerGroup[] = [];
  for (const [i, group] of geometry.groups.entries()) {
    const groupStart = Math.max(start, group.start) - start;
    const groupEnd = Math.min(end, group.start + group.count) - start;
    if (groupEnd <= groupStart) continue;
    if (groupStart % 3 !== 0) {
      throw new RangeError(
        `${label}: group ${i} starts at ${unit} ${group.start}, inside a triangle. Start groups and draw range at multiples of three.`,
      );
    }
    const groupCount = groupEnd - groupStart;
    groups.push({ start: groupStart, count: groupCount - (groupCount % 3), materialIndex: group.materialIndex });
  }
  return { start, count, groups };
}

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
