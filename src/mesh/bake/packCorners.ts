import { vertexAcross } from '../corners.js';
import { forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { CORNER_STRIDE } from './attributeLayouts.js';

/** The vertex buffers of the `corner` layout. */
export interface PackedCorners {
  /** x, y, z of each corner. */
  positions: Float32Array<ArrayBuffer>;
  /** `CORNER_STRIDE` floats per corner, in the order of `cornerLayout`. */
  corners: Float32Array<ArrayBuffer>;
}

/** Writes the `corner` layout: for every corner the positions of the six adjacency vertices of its triangle. */
export function* packCorners(mesh: TriangleMesh, twins: Int32Array): Generator<number, PackedCorners, void> {
  const cornerCount = mesh.indices.length;
  const packed = {
    positions: new Float32Array(3 * cornerCount),
    corners: new Float32Array(CORNER_STRIDE * cornerCount),
  };
  yield* forEachChunk(cornerCount / 3, (start, end) => packRange(mesh, twins, packed, start, end));
  return packed;
}

function packRange(
  { positions: vertices, indices }: TriangleMesh,
  twins: Int32Array,
  { positions, corners }: PackedCorners,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const alpha = vertexAcross(indices, twins, first);
    const beta = vertexAcross(indices, twins, first + 1);
    const gamma = vertexAcross(indices, twins, first + 2);
    let own = indices[first];
    let next = indices[first + 1];
    let previous = indices[first + 2];
    for (let k = 0; k < 3; k++) {
      const target = CORNER_STRIDE * (first + k);
      copyPosition(vertices, own, positions, 3 * (first + k));
      copyPosition(vertices, next, corners, target);
      corners[target + 3] = k;
      copyPosition(vertices, previous, corners, target + 4);
      copyPosition(vertices, alpha, corners, target + 7);
      copyPosition(vertices, beta, corners, target + 10);
      copyPosition(vertices, gamma, corners, target + 13);
      const rotated = own;
      own = next;
      next = previous;
      previous = rotated;
    }
  }
}

function copyPosition(vertices: Float32Array, vertex: number, target: Float32Array, offset: number): void {
  target[offset] = vertices[3 * vertex];
  target[offset + 1] = vertices[3 * vertex + 1];
  target[offset + 2] = vertices[3 * vertex + 2];
}
