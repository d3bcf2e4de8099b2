import { assertHatchImages, checkHatchImages, type HatchImageReport } from '../hatchImages/checkHatchImages.js';
import { deriveThresholds } from '../hatchImages/deriveThresholds.js';
import { encodeThresholds, type ThresholdLevel } from '../hatchImages/encodeThresholds.js';
import { DEFAULT_STROKE_WIDTH, type HatchImages } from '../hatchImages/HatchImages.js';
import { type HatchImageOptions, resolveHatchImageOptions } from '../hatchImages/hatchImageOptions.js';
import type { TonalArtMapSource } from '../mapFiles/readSource.js';
import { checkNames, checkOptions } from '../worker/checkOptions.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { HATCH_IMAGE_OPTIONS } from './checkHatchImageOptions.js';
import { measureThresholdMoments, type ThresholdMoments } from './measureThresholdMoments.js';
import { type PackedLevel, packHatchImages, unpackHatchImage } from './packHatchImages.js';
import { pairThresholdLevels, type ThresholdPair } from './pairThresholdLevels.js';
import { ThresholdTexture } from './ThresholdTexture.js';
import { TonalArtMapTexture } from './TonalArtMapTexture.js';

/** Share of the progress for drawing the images; the rest is for the thresholds. */
const IMAGES_SHARE = 0.7;

/** Share of the progress of `load` for reading the files. */
const READING_SHARE = 0.5;

/** What a map is drawn with. */
export type MapDrawing = HatchImageOptions;

/** What `TonalArtMap.generate` accepts: what to draw, and how to follow and stop the task. */
export interface TonalArtMapOptions extends HatchImageOptions, TaskOptions {}

/** What `fromHatchImages` reads. */
const HATCH_IMAGES = { size: true, images: true, strokeWidth: true } satisfies Record<keyof HatchImages, true>;

/**
 * A tonal art map: hatch images for several tones at several resolutions. When tone or distance changes, strokes keep their
 * place and their width (Praun et al. 2001; Suarez et al., section 3.1).
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
  /** Width of the strokes in texels, the same on every level. */
  readonly strokeWidth: number;
  /**
   * RGBA array texture with drawn mip levels, not colour data. Layer l, channel c holds tone min(3l + c, tones − 1), so
   * that one fetch reads both neighbours of any tone; 1 = paper, 0 = ink.
   */
  readonly texture: TonalArtMapTexture;

  private readonly packed: PackedLevel[];
  private cachedReport: HatchImageReport | undefined;
  private thresholdLevels: ThresholdLevel[] | undefined;
  private pairs: ThresholdPair[] | undefined;
  private cachedThresholdTexture: ThresholdTexture | undefined;
  private cachedMoments: ThresholdMoments | undefined;

  /** @param hasDrawnThresholds whether the thresholds were drawn, and so cannot be derived from the images again */
  private constructor(
    { size, images, strokeWidth = DEFAULT_STROKE_WIDTH }: HatchImages,
    thresholdLevels: ThresholdLevel[] | undefined,
    private readonly hasDrawnThresholds: boolean,
  ) {
    this.size = size;
    this.tones = images.length;
    this.levels = images[0].length;
    this.strokeWidth = strokeWidth;
    this.packed = packHatchImages(size, images);
    this.thresholdLevels = thresholdLevels;
    this.texture = new TonalArtMapTexture(this.packed, this.tones);
  }

  /**
   * Draws a map, in a worker where there are any. The same options give the same bytes.
   *
   * @throws RangeError or TypeError (as a rejection) if an option is out of its range or unknown; the signal's reason if it aborts
   */
  static async generate(options: TonalArtMapOptions = {}): Promise<TonalArtMap> {
    checkOptions('TonalArtMap.generate', options, HATCH_IMAGE_OPTIONS);
    const { style, seed, size, tones, levels, strokeWidth, ...taskOptions } = options;
    const request: HatchImageOptions = { style, seed, size, tones, levels, strokeWidth };
    resolveHatchImageOptions(request);
    const { onProgress } = taskOptions;
    const makeRequest = (): HatchImageOptions => request;
    const images = await runTask(
      'generateHatchImages',
      request,
      { ...taskOptions, onProgress: onProgress && ((progress) => onProgress(IMAGES_SHARE * progress)) },
      makeRequest,
    );
    const thresholds = await runTask(
      'generateThresholds',
      request,
      {
        ...taskOptions,
        onProgress: onProgress && ((progress) => onProgress(IMAGES_SHARE + (1 - IMAGES_SHARE) * progress)),
      },
      makeRequest,
    );
    return new TonalArtMap(images, thresholds, true);
  }

  /**
   * Makes a map from your own images. They are copied.
   *
   * @param hatchImages `images[tone][level]`, the lightest tone and the finest level first; (size / 2^level)² bytes each
   *   in rows of growing v, 255 = paper, 0 = ink. Two to 64 tones, with up to 2²⁶ texels of the finest level together; one
   *   level is enough. `size` is a power of two up to 4096.
   * @throws TypeError or RangeError if their shape is not that of a map. Images that break the constraints of a map (nesting,
   *   order of means) are accepted; see `report`.
   */
  static fromHatchImages(hatchImages: HatchImages): TonalArtMap {
    checkNames('TonalArtMap.fromHatchImages', 'hatch images', hatchImages, HATCH_IMAGES);
    assertHatchImages(hatchImages);
    return new TonalArtMap(hatchImages, undefined, false);
  }

  /**
   * Loads a map written by `save`, or images that an artist has drawn, one PNG per tone. To the latter, blank paper is added
   * as the lightest tone if it is missing, and the other levels are made (see docs/maps.md). Up to 64 tones, with up to 2²⁶
   * texels of the finest level together.
   *
   * @param source the address of the JSON file of a map; or addresses of images, lightest first; or files, for example
   *   dropped ones: all files of a map, or images in any order, which are then sorted by darkness
   * @throws Error (as a rejection) naming the file that is missing or wrong and what to do; the signal's reason if it aborts
   */
  static async load(source: TonalArtMapSource, options: TaskOptions = {}): Promise<TonalArtMap> {
    checkOptions('TonalArtMap.load', options);
    const { signal, onProgress } = options;
    signal?.throwIfAborted();
    const onRead = (progress: number): void => onProgress?.(READING_SHARE * progress);
    const { readSource } = await import('../mapFiles/readSource.js');
    const { lacksLevels, thresholds, ...read } = await readSource(source, signal, onRead);
    signal?.throwIfAborted();
    assertHatchImages(read);
    if (thresholds) {
      const levels = thresholds.map((field, level) => encodeThresholds(read.size >> level, field));
      onProgress?.(1);
      return new TonalArtMap(read, levels, true);
    }
    const { thresholds: levels, ...images } = await runTask(
      'completeHatchImages',
      { ...read, lacksLevels },
      { ...options, onProgress: onProgress && ((done) => onProgress(READING_SHARE + (1 - READING_SHARE) * done)) },
      async () => ({ ...(await readSource(source, signal, () => {})), lacksLevels }),
    );
    return new TonalArtMap({ ...images, strokeWidth: read.strokeWidth }, levels, false);
  }

  /** How well the images keep the constraints of a tonal art map. Measured on first use. */
  get report(): HatchImageReport {
    if (!this.cachedReport) {
      this.cachedReport = checkHatchImages(this.allImages());
    }
    return this.cachedReport;
  }

  /**
   * The thresholds as a texture, for techniques that blend first and decide on ink last. Not colour data; the levels lie side
   * by side instead of in mip levels. A texel t stands for g = 6t − 3 = Φ⁻¹(h), clamped to ±3, where h is the tone at which
   * it becomes ink. So g is normally distributed, and h = Φ(g). Red is the level itself, green the next coarser one. Made on
   * first use.
   */
  get thresholdTexture(): ThresholdTexture {
    this.cachedThresholdTexture ??= new ThresholdTexture(this.thresholdPairs());
    return this.cachedThresholdTexture;
  }

  /** How much interpolation reduces the contrast of the thresholds, so that shaders can restore it. Measured on first use. */
  get thresholdMoments(): ThresholdMoments {
    this.cachedMoments ??= measureThresholdMoments(this.thresholdPairs());
    return this.cachedMoments;
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
    this.assertLevel('image', level);
    return unpackHatchImage(this.packed[level], tone);
  }

  /**
   * A copy of one level's thresholds: (size / 2^level)² numbers in (0, 1) in rows of growing v, uniformly distributed. At tone
   * T (0 = paper, 1 = darkest) a texel is ink if its number is below T, so {threshold < T} is a drawing of mean ink T. A
   * generated map draws them; a map of your own images derives them from the images.
   *
   * @throws RangeError if there is no such level
   */
  thresholds(level: number): Float32Array {
    this.assertLevel('thresholds', level);
    return this.thresholdMap()[level].thresholds.slice();
  }

  /**
   * The map as files: `map.json` and the PNG images it names, one per tone and level. `load` makes exactly the same map of
   * them, thresholds included.
   */
  async save(): Promise<File[]> {
    const thresholds = this.hasDrawnThresholds ? this.thresholdMap().map((level) => level.thresholds) : undefined;
    const { writeMapFiles } = await import('../mapFiles/writeMapFiles.js');
    const files = await writeMapFiles(this.allImages(), thresholds);
    return files.map(({ name, bytes }) => {
      const type = name.endsWith('.json') ? 'application/json' : 'image/png';
      return new File([bytes as Uint8Array<ArrayBuffer>], name, { type });
    });
  }

  /** Frees the textures on the GPU. A material that still uses the map uploads them again. */
  dispose(): void {
    this.texture.dispose();
    this.cachedThresholdTexture?.dispose();
  }

  private thresholdMap(): ThresholdLevel[] {
    if (this.thresholdLevels) return this.thresholdLevels;
    const task = deriveThresholds(this.allImages());
    let step = task.next();
    while (!step.done) step = task.next();
    this.thresholdLevels = step.value;
    return step.value;
  }

  private thresholdPairs(): ThresholdPair[] {
    this.pairs ??= pairThresholdLevels(this.thresholdMap());
    return this.pairs;
  }

  private allImages(): HatchImages {
    const images = Array.from({ length: this.tones }, (_, tone) =>
      Array.from({ length: this.levels }, (_, level) => this.image(tone, level)),
    );
    return { size: this.size, images, strokeWidth: this.strokeWidth };
  }

  private assertLevel(method: string, level: number): void {
    if (Number.isInteger(level) && level >= 0 && level < this.levels) return;
    throw new RangeError(
      `TonalArtMap.${method}: level is ${level}, but must be a whole number from 0 to ${this.levels - 1}.`,
    );
  }
}
