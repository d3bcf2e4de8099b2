/** Triangles as a camera sees them. Plain data, in world space and on the sheet. */
export interface ProjectedTriangles {
  count: number;
  /**
   * Three numbers for each of three corners: x and y on the sheet, where −1 and 1 are its edges, and how near the corner is to the
   * eye. Nearness grows towards the eye, and is linear on the sheet.
   */
  corners: Float32Array;
  /** The unit normal of each triangle, on the side that is seen. */
  normals: Float32Array;
  /** The share of a light with a direction that the hollows of the surface leave it: 1 where nothing is baked. */
  openness: Float32Array;
  /** 1 for a triangle that stands for several like it, which are not among the others. */
  isSample: Uint8Array;
}

const NUMBERS_PER_TRIANGLE = 9;

/** Room for this many triangles. */
export const createProjectedTriangles = (most: number): ProjectedTriangles => ({
  count: 0,
  corners: new Float32Array(NUMBERS_PER_TRIANGLE * most),
  normals: new Float32Array(3 * most),
  openness: new Float32Array(most),
  isSample: new Uint8Array(most),
});
