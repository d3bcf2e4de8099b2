/** A rendered surface: what every measure reads. Rows may run up or down, as long as all images of a measurement agree. */
export interface SurfaceImage {
  readonly width: number;
  readonly height: number;
  /** Linear light per pixel: 0 is ink, 1 paper. */
  readonly luminance: Float32Array;
  /** Nonzero where the pixel shows the surface; all other pixels are ignored. */
  readonly surface: Uint8Array;
}

/** Black or white: what a pixel is taken for where a measure counts strokes. */
export const isInk = (luminance: number): boolean => luminance < 0.5;
