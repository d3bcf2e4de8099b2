import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { assertHatchImages, checkHatchImages, type HatchImageReport } from './checkHatchImages.js';
import { type HatchImageOptions, type HatchImages, resolveHatchImageOptions } from './generateHatchImages.js';
import { type PackedLevel, packHatchImages, unpackHatchImage } from './packHatchImages.js';
import { TonalArtMapTexture } from './TonalArtMapTexture.js';

/** What `TonalArtMap.generate` accepts: what to draw, and how to watch and stop the drawing. */
export interface TonalArtMapOptions extends HatchImageOptions, TaskOptions {}

/**
 * A tonal art map: hatch images for several tones at several resolutions, so that strokes stay where they are and stay
 * as wide when tone or distance change (Praun et al. 2001; section 3.1 of the paper).
 *
 * Image k of n stands for tone k/(n−1), 0 = paper, 1 = darkest. Strokes run along u. Immutable; may be shared by any
 * number of materials and renderers.
 */
export class TonalArtMap {
  /** Texels per side of level 0. */
  readonly size: number;
  /** Number of tones. */
  readonly tones: number;
  /** Number of levels; each has half the texels per side of the one before. */
  readonly levels: number;
  /**
   * RGBA array texture with drawn mip levels, not colour data. Layer l, channel c holds tone min(3l + c, tones − 1), so
   * that one fetch reads both neighbours of any tone; 1 = paper, 0 = ink.
   */
  readonly texture: TonalArtMapTexture;

  private readonly packed: PackedLevel[];
  private measured: HatchImageReport | undefined;

  private constructor({ size, images }: HatchImages) {
    this.size = size;
    this.tones = images.length;
    this.levels = images[0].length;
    this.packed = packHatchImages(size, images);
    this.texture = new TonalArtMapTexture(this.packed, this.tones);
  }

  /**
   * Draws a map, in a worker where there are any. The same options give the same bytes.
   *
   * @throws RangeError (as a rejection) if an option is out of its range; the signal's reason if it aborts
   */
  static async generate(options: TonalArtMapOptions = {}): Promise<TonalArtMap> {
    const { style, seed, size, tones, levels, strokeWidth, ...taskOptions } = options;
    const request: HatchImageOptions = { style, seed, size, tones, levels, strokeWidth };
    resolveHatchImageOptions(request);
    return new TonalArtMap(await runTask('generateHatchImages', request, taskOptions));
  }

  /**
   * Makes a map of anyone's images. They are copied.
   *
   * @param hatchImages `images[tone][level]`, the lightest tone and the finest level first; (size / 2^level)² bytes each
   *   in rows of growing v, 255 = paper, 0 = ink. At least two tones; one level is enough. `size` is a power of two.
   * @throws TypeError or RangeError if they cannot be a map. Images that can but break its constraints (nesting, order of
   *   means) are accepted; see `report`.
   */
  static fromHatchImages(hatchImages: HatchImages): TonalArtMap {
    assertHatchImages(hatchImages);
    return new TonalArtMap(hatchImages);
  }

  /** How well the images keep the constraints of a tonal art map. Measured when first asked for. */
  get report(): HatchImageReport {
    if (!this.measured) {
      const images = Array.from({ length: this.tones }, (_, tone) =>
        Array.from({ length: this.levels }, (_, level) => this.image(tone, level)),
      );
      this.measured = checkHatchImages({ size: this.size, images });
    }
    return this.measured;
  }

  /**
   * A copy of one hatch image: (size / 2^level)² bytes in rows of growing v, 255 = paper, 0 = ink.
   *
   * @throws RangeError if there is no such tone or level
   */
  image(tone: number, level: number): Uint8Array {
    if (!Number.isInteger(tone) || tone < 0 || tone >= this.tones) {
      throw new RangeError(
        `TonalArtMap.image: tone is ${tone}, but must be a whole number from 0 to ${this.tones - 1}.`,
      );
    }
    if (!Number.isInteger(level) || level < 0 || level >= this.levels) {
      throw new RangeError(
        `TonalArtMap.image: level is ${level}, but must be a whole number from 0 to ${this.levels - 1}.`,
      );
    }
    return unpackHatchImage(this.packed[level], tone);
  }

  /** Frees the texture on the GPU. A material that still uses the map uploads it again. */
  dispose(): void {
    this.texture.dispose();
  }
}
