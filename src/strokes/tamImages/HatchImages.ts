/** Hatch images as bytes, 255 = paper, 0 = ink. */
export interface HatchImages {
  /** Texels per side of level 0. */
  size: number;
  /**
   * `images[tone][level]`: (size / 2^level)² bytes in rows of growing v, strokes along u. Image k of n stands for tone
   * k/(n−1); image 0 is the lightest.
   */
  images: Uint8Array[][];
  /** Width of the strokes in texels, the same on every level. Default: `DEFAULT_STROKE_TEXELS`. */
  strokeTexels?: number | undefined;
}

/** The width of strokes in texels, for images that do not state it. */
export const DEFAULT_STROKE_TEXELS = 2;
