import { CORNER_STRIDE } from './cornerLayout.js';
import { NO_TWIN, previousCorner } from './corners.js';
import { inChunks } from './inChunks.js';
import type { TriangleMesh } from './TriangleMesh.js';

/** The vertex buffers of the `corner` layout. */
export interface PackedCorners {
  /** x, y, z of each corner. */
  positions: Float32Array<ArrayBuffer>;
  /** `CORNER_STRIDE` floats per corner, in the order of `cornerLayout`. */
  corners: Float32Array<ArrayBuffer>;
}

/** Writes the `corner` layout: for every corner the positions of the six adjacency vertices of its triangle. */
export function* packCorners(mesh: TriangleMesh, twins: Int32Array): Generator<number, PackedCorners, void> {
  const { positions: vertices, indices } = mesh;
  const cornerCount = indices.length;
  const positions = new Float32Array(3 * cornerCount);
  const corners = new Float32Array(CORNER_STRIDE * cornerCount);

  /** The vertex opposite to the edge, seen from its own triangle or, where it has a twin, from the neighbour. */
  const oppositeAcross = (corner: number): number => {
    const twin = twins[corner]!;
    return 3 * indices[previousCorner(twin === NO_TWIN ? corner : twin)]!;
  };
  const writePosition = (target: number, vertex: number): void => {
    corners[target] = vertices[vertex]!;
    corners[target + 1] = vertices[vertex + 1]!;
    corners[target + 2] = vertices[vertex + 2]!;
  };

  yield* inChunks(cornerCount / 3, (start, end) => {
    for (let first = 3 * start; first < 3 * end; first += 3) {
      const own = [3 * indices[first]!, 3 * indices[first + 1]!, 3 * indices[first + 2]!] as const;
      const alpha = oppositeAcross(first);
      const beta = oppositeAcross(first + 1);
      const gamma = oppositeAcross(first + 2);
      for (let k = 0; k < 3; k++) {
        const corner = first + k;
        const vertex = own[k]!;
        positions[3 * corner] = vertices[vertex]!;
        positions[3 * corner + 1] = vertices[vertex + 1]!;
        positions[3 * corner + 2] = vertices[vertex + 2]!;
        const target = CORNER_STRIDE * corner;
        writePosition(target, own[(k + 1) % 3]!);
        corners[target + 3] = k;
        writePosition(target + 4, own[(k + 2) % 3]!);
        writePosition(target + 7, alpha);
        writePosition(target + 10, beta);
        writePosition(target + 13, gamma);
      }
    }
  });
  return { positions, corners };
}
