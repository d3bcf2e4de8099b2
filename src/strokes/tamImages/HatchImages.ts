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

/** The largest number of texels per side of a map. */
export const MAX_SIDE = 4096;

/** The largest number of tones of a map. The eye can hardly distinguish more than 16. */
const MAX_TONES = 64;

/**
 * The largest number of texels of the finest level, all tones together. Preparing that many takes about half a minute and half a gigabyte.
 */
const MAX_TEXELS = 4 * MAX_SIDE ** 2;

/** The fault of a map with too many tones, as the rest of a sentence that begins with its name, or undefined. */
export function excessOfTones(tones: number): string | undefined {
  return tones > MAX_TONES ? `has ${tones} tones, but at most ${MAX_TONES} are allowed; leave some out` : undefined;
}

/** The fault of a map that is too large, as the rest of a sentence that begins with its name, or undefined. */
export function excessOf(tones: number, size: number): string | undefined {
  if (tones * size ** 2 <= MAX_TEXELS) return excessOfTones(tones);
  return `has ${tones} tones of ${size} × ${size} texels, but at most ${MAX_TEXELS / size ** 2} of that size are allowed; make the images smaller, or leave some out`;
}
