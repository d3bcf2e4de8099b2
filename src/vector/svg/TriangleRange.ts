/** The triangles of a mesh that one material draws. */
export interface TriangleRange {
  /** The vertices of corners. */
  corners: Uint32Array;
  /** The triangle of the scene that the first of them is. */
  firstTriangle: number;
}
