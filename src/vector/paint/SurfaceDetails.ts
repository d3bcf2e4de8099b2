import type { Mat3 } from '../shading/screenGradient.js';

/**
 * What only some surfaces have at their vertices, linear over the triangles that they were read with, however small these are divided
 * later.
 */
export interface SurfaceDetails {
  /** The first triangle of the scene that belongs to the surface, and the vertices of the corners of all of them. */
  firstTriangle: number;
  corners: ArrayLike<number>;
  /** Numbers per vertex, and these numbers. */
  stride: number;
  numbers: ArrayLike<number>;
  /**
   * Where the nine numbers of the map from the view to the field lie, row by row, of a surface that deforms: the field is that of the
   * surface at rest. Null where one map is enough.
   */
  viewToField: number | null;
}

/** The maps from the view to the field of a place on a surface that deforms: as it is shaded, and as the flat triangle lies. */
export interface PosedMaps {
  smooth: Mat3;
  flat: Mat3;
}
