import { forEachChunk } from './phases.js';

/**
 * A triangle mesh as plain typed arrays, without three.js: the input of the bake.
 *
 * Invariants, checked by `validateTriangleMesh`: at least one triangle; `indices.length` is a multiple of three; every
 * index names a vertex; every position that a triangle uses is finite.
 */
export interface TriangleMesh {
  /** x, y, z of each vertex, in object space. */
  positions: Float32Array<ArrayBuffer>;
  /** The vertex of each corner: three entries per triangle. */
  indices: Uint32Array<ArrayBuffer>;
}

/**
 * Throws a RangeError with the fault of `mesh` and its remedy. Vertices that no triangle uses are not checked.
 *
 * @param label start of the message: the function that was called and the geometry that was passed
 */
export function* validateTriangleMesh(mesh: TriangleMesh, label: string): Generator<number, void, void> {
  const { positions, indices } = mesh;
  if (indices.length === 0) {
    throw new RangeError(`${label} has no triangles. Pass one with at least three vertices, or skip it.`);
  }
  if (indices.length % 3 !== 0) {
    throw new RangeError(
      `${label} has ${indices.length} corners, which is not a multiple of three. Remove the incomplete last triangle, or convert strips and lines to triangles first.`,
    );
  }
  yield* forEachChunk(indices.length, (start, end) => {
    const corner = findBadCorner(mesh, start, end);
    if (corner === end) return;
    const vertex = indices[corner];
    if (vertex >= positions.length / 3) {
      throw new RangeError(
        `${label}: corner ${corner} refers to vertex ${vertex}, but there are only ${positions.length / 3} vertices. Fix the index, or the exporter that wrote it.`,
      );
    }
    throw new RangeError(
      `${label}: the position of vertex ${vertex} is (${positions.slice(3 * vertex, 3 * vertex + 3).join(', ')}). Positions must be finite 32-bit floats: repair or remove the triangles that use this vertex.`,
    );
  });
}

/** The first corner in the range whose vertex does not exist or is not finite, or `end`. */
function findBadCorner({ positions, indices }: TriangleMesh, start: number, end: number): number {
  const vertexCount = positions.length / 3;
  for (let corner = start; corner < end; corner++) {
    const vertex = indices[corner];
    if (vertex >= vertexCount) return corner;
    const x = positions[3 * vertex];
    const y = positions[3 * vertex + 1];
    const z = positions[3 * vertex + 2];
    // x − x is 0 for every finite x and NaN for all others.
    if (x - x + (y - y) + (z - z) !== 0) return corner;
  }
  return end;
}
