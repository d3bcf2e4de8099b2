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
