/** Triangles as a camera sees them: plain data, in world space and on the sheet. */
export interface ProjectedTriangles {
  count: number;
  /**
   * Three numbers for each of three corners: x and y on the sheet, where −1 and 1 are its edges, and how near the corner is to the
   * eye. Nearness grows towards the eye, and is linear on the sheet.
   */
  corners: Float32Array;
  /** The unit normal of each triangle, on the visible side. */
  normals: Float32Array;
  /** The share of directional light that reaches each triangle through its baked occlusion: 1 without a bake. */
  openness: Float32Array;
  /** 1 for a triangle that stands for several omitted ones like it. */
  isSample: Uint8Array;
}

const NUMBERS_PER_TRIANGLE = 9;

/** Allocates room for a number of triangles. */
export const createProjectedTriangles = (most: number): ProjectedTriangles => ({
  count: 0,
  corners: new Float32Array(NUMBERS_PER_TRIANGLE * most),
  normals: new Float32Array(3 * most),
  openness: new Float32Array(most),
  isSample: new Uint8Array(most),
});
