/** A rendered surface, the input of every measure. Rows may run up or down, as long as all images of a measurement agree. */
export interface SurfaceImage {
  readonly width: number;
  readonly height: number;
  /** Linear light per pixel: 0 is ink, 1 paper. */
  readonly luminance: Float32Array;
  /** Nonzero where the pixel shows the surface; all other pixels are ignored. */
  readonly surface: Uint8Array;
}

/** Whether a pixel counts as ink, for measures that count strokes. */
export const isInk = (luminance: number): boolean => luminance < 0.5;
