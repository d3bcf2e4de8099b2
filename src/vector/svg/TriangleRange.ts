/** A range of triangles of a mesh with one material. */
export interface TriangleRange {
  /** Vertices of corners. */
  corners: Uint32Array;
  /** Index of the first of them among the triangles of the scene. */
  firstTriangle: number;
}
