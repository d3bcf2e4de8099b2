/** Lines of one set on the surfaces of a scene, which the next frame takes over. */
export interface SurfaceLines {
  /** The surfaces that are drawn together, by their place in the order of drawing, and the set. */
  group: number;
  set: number;
  /** The number of triangles of the scene. */
  count: number;
  /** Per point its triangle of the scene, and the weights of the second and the third corner. */
  triangles: Int32Array;
  weights: Float64Array;
  /** The first point of each line, and the end of the last. */
  starts: readonly number[];
  /** Per line its chance, from 0 to 1, and its number. */
  lots: readonly number[];
  ids: readonly number[];
}
