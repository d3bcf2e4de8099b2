import type { Mat3 } from '../shading/screenGradient.js';

/** Numbers of vertices that only some surfaces have, linear over the triangles of the scene, however small these are subdivided later. */
export interface SurfaceDetails {
  /** The first triangle of the scene that belongs to the surface, and the vertices of the corners of all its triangles. */
  firstTriangle: number;
  corners: ArrayLike<number>;
  /** Count of numbers per vertex, and the numbers. */
  stride: number;
  numbers: ArrayLike<number>;
  /**
   * Offset of the nine numbers, row by row, of the map from view to field of a surface that deforms, whose field is that of the surface at
   * rest. Null if one map serves the whole surface.
   */
  viewToField: number | null;
}

/** The maps from view to field at a place on a surface that deforms: of the smooth surface, and of the flat triangle. */
export interface PosedMaps {
  smooth: Mat3;
  flat: Mat3;
}
