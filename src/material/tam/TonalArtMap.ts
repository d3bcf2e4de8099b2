import { runToEnd } from '../../mesh/phases.js';
import type { TonalArtMapSource } from '../../strokes/mapFiles/readSource.js';
import type { StrokeStyleName } from '../../strokes/strokeStyleNames.js';
import {
  assertHatchImages,
  checkHatchImages,
  type HatchImageReport,
} from '../../strokes/tamImages/checkHatchImages.js';
import type { MapRequest } from '../../strokes/tamImages/generateHatchImages.js';
import { DEFAULT_STROKE_TEXELS, type HatchImages } from '../../strokes/tamImages/HatchImages.js';
import { type MapDrawing, resolveMapDrawing } from '../../strokes/tamImages/hatchImageOptions.js';
import { deriveThresholds, encodeThresholds, type ThresholdLevel } from '../../strokes/tamImages/thresholds.js';
import { runTask } from '../../worker/runTask.js';
import { checkNames, checkOptions, type TaskOptions } from '../../worker/TaskOptions.js';
import { HATCH_IMAGE_OPTIONS } from './checkHatchImageOptions.js';
import { type PackedLevel, packHatchImages, TonalArtMapTexture, unpackHatchImage } from './TonalArtMapTexture.js';
import {
  measureThresholdMoments,
  pairThresholdLevels,
  type ThresholdMoments,
  type ThresholdPair,
  ThresholdTexture,
} from './thresholds.js';

/** The share of the progress for drawing the images; the rest is for the thresholds. */
const IMAGES_SHARE = 0.7;

/** Draws the images and thresholds of a map, in a worker if possible. */
async function drawHatchImages(
  drawing: MapDrawing,
  { onProgress, ...options }: TaskOptions,
): Promise<{ images: HatchImages; thresholds: ThresholdLevel[] }> {
  // The code that prepares hands is fetched with the first of them.
  const request = drawing.hand
    ? await (await import('./prepareInSlices.js')).prepareInSlices(drawing, options.signal)
    : (drawing as MapRequest);
  const again = (): MapRequest => request;
  const partOf = (from: number, share: number): TaskOptions => ({
    ...options,
    onProgress: onProgress && ((progress) => onProgress(from + share * progress)),
  });
  const images = await runTask('generateHatchImages', request, partOf(0, IMAGES_SHARE), again);
  const thresholds = await runTask('generateThresholds', request, partOf(IMAGES_SHARE, 1 - IMAGES_SHARE), again);
  return { images, thresholds };
}

/** The share of the progress of `load` for reading the files. */
const READING_SHARE = 0.5;

/** Options of `TonalArtMap.draw` and `generate`: those that determine the map, and those of the task. */
export interface TonalArtMapOptions extends MapDrawing, TaskOptions {}

/** The names of the properties that `fromHatchImages` reads. */
const HATCH_IMAGES = { size: true, images: true, strokeTexels: true } satisfies Record<keyof HatchImages, true>;

/** The maps of `TonalArtMap.shared`, keyed by the options that determine them. */
const sharedMaps = /* @__PURE__ */ new Map<string, TonalArtMap>();

/** The properties of a map that are known before it is drawn. */
interface MapShape {
  size: number;
  tones: number;
  levels: number;
  strokeTexels: number;
}

/** The images and thresholds of a map. */
interface MapContent {
  packed: PackedLevel[];
  /** Undefined until they are derived from the images. */
  thresholds: ThresholdLevel[] | undefined;
  /** Whether the thresholds were drawn, and so cannot be derived from the images again. */
  hasDrawnThresholds: boolean;
}

/**
 * A tonal art map: hatch images for several tones at several resolutions. When tone or distance changes, strokes keep their place
 * and their width (Praun et al. 2001; Suarez et al., section 3.1).
 *
 * Image k of n stands for tone k/(n−1), where 0 is paper and 1 the darkest tone. Strokes run along u. A map never changes once it is
 * ready, and may be shared by any number of materials and renderers.
 */
export class TonalArtMap {
  readonly isTonalArtMap = true;
  /** Texels per side of level 0. */
  readonly size: number;
  /** Number of tones. */
  readonly tones: number;
  /** Number of levels. Each has half the texels per side of the previous level. */
  readonly levels: number;
  /** Width of the strokes in texels, the same on every level. */
  readonly strokeTexels: number;
  /**
   * The hatch images, as an RGBA array texture with drawn mip levels; without an image until the map is ready. It holds no colours:
   * layer l, channel c holds tone min(3l + c, tones − 1), 1 = paper, 0 = ink, so that one fetch reads both neighbours of any tone.
   */
  readonly texture: TonalArtMapTexture;

  private content: MapContent | undefined;
  private drawn: Promise<TonalArtMap> | undefined;
  private hasListener = false;
  private cachedReport: HatchImageReport | undefined;
  private pairs: ThresholdPair[] | undefined;
  private cachedThresholdTexture: ThresholdTexture | undefined;
  private cachedMoments: ThresholdMoments | undefined;

  private constructor(shape: MapShape) {
    // The private constructor is enforced by TypeScript only.
    if (!shape?.tones || !shape.levels) {
      throw new TypeError('TonalArtMap: a map is not made with "new". Use draw(), fromHatchImages() or await load().');
    }
    const { size, tones, levels, strokeTexels } = shape;
    this.size = size;
    this.tones = tones;
    this.levels = levels;
    this.strokeTexels = strokeTexels;
    this.texture = new TonalArtMapTexture(size, levels, tones);
  }

  /**
   * Starts to draw a map, in a worker if possible, and returns it at once, as three's own loaders do. Materials with the map are blank
   * paper until it is drawn, and hatch from the next frame on. The same options give the same bytes.
   *
   * Size, tones, levels and the width of strokes are known at once. Members that read the images (`image`, `report`, `save`, …) throw
   * an Error until `ready` is resolved.
   *
   * ```ts
   * const tonalArtMap = TonalArtMap.draw({ style: 'contours' });
   * mesh.material = new HatchingMaterial({ tonalArtMap });
   * tonalArtMap.ready.then(render); // for a page that does not draw all the time
   * ```
   *
   * @throws RangeError or TypeError if an option is out of its range or unknown
   */
  static draw(options: TonalArtMapOptions = {}): TonalArtMap {
    return TonalArtMap.begin('TonalArtMap.draw', options);
  }

  /**
   * Draws a map as `draw` does, and returns it when it is ready.
   *
   * @throws RangeError or TypeError (as a rejection) if an option is out of its range or unknown; the signal's reason when aborted
   */
  static async generate(options: TonalArtMapOptions = {}): Promise<TonalArtMap> {
    return TonalArtMap.begin('TonalArtMap.generate', options).ready;
  }

  /**
   * The shared map for given options, which materials that name its style use too. It is drawn on first use, here or in a material's
   * first frame, and is kept as long as the page. If drawing fails, the next call tries again.
   *
   * ```ts
   * TonalArtMap.shared().ready.then(render); // for a page that does not draw all the time
   * ```
   *
   * @param drawing the style, `hatching` by default, or the options that determine the map
   * @param options the task options of the first call
   * @throws RangeError or TypeError if an option is out of its range or unknown
   */
  static shared(drawing: StrokeStyleName | MapDrawing = {}, options: TaskOptions = {}): TonalArtMap {
    const own: MapDrawing = typeof drawing === 'string' ? { style: drawing } : drawing;
    const { style = 'hatching', ...others } = own;
    const given = Object.entries(others).filter(([, value]) => value !== undefined);
    const key = JSON.stringify([style, ...given.sort(([a], [b]) => (a < b ? -1 : 1))]);
    const known = sharedMaps.get(key);
    if (known) return known;
    const map = TonalArtMap.begin('TonalArtMap.shared', { ...options, ...own });
    sharedMaps.set(key, map);
    map.drawn?.catch(() => sharedMaps.delete(key));
    return map;
  }

  private static begin(caller: string, options: TonalArtMapOptions): TonalArtMap {
    checkOptions(caller, options, HATCH_IMAGE_OPTIONS);
    const { style, hand, seed, size, tones, levels, strokeTexels, ...taskOptions } = options;
    const drawing: MapDrawing = { style, hand, seed, size, tones, levels, strokeTexels };
    const map = new TonalArtMap(resolveMapDrawing(drawing, caller));
    map.drawn = drawHatchImages(drawing, taskOptions).then(({ images, thresholds }) =>
      map.fill(images, thresholds, true),
    );
    map.drawn.catch((error: unknown) => {
      if (!map.hasListener && !taskOptions.signal?.aborted)
        console.error(`${caller}: the map could not be drawn (${messageOf(error)}); surfaces stay blank paper.`);
    });
    return map;
  }

  private static of(
    images: HatchImages,
    thresholds: ThresholdLevel[] | undefined,
    hasDrawnThresholds: boolean,
  ): TonalArtMap {
    const { size, images: tones, strokeTexels = DEFAULT_STROKE_TEXELS } = images;
    const map = new TonalArtMap({ size, tones: tones.length, levels: tones[0].length, strokeTexels });
    return map.fill(images, thresholds, hasDrawnThresholds);
  }

  /**
   * Makes a map from your own images, which are copied.
   *
   * @param hatchImages `images[tone][level]`, the lightest tone and the finest level first. Each image has (size / 2^level)² bytes
   * in rows of growing v, 255 = paper, 0 = ink. There may be two to 64 tones, whose finest levels together have up to 2²⁶
   * texels; one level is enough. `size` is a power of two up to 4096.
   * @throws TypeError or RangeError if the images do not have the shape of a map. Images that break the constraints of a map
   * (nesting, order of means) are accepted; see `report`.
   */
  static fromHatchImages(hatchImages: HatchImages): TonalArtMap {
    checkNames('TonalArtMap.fromHatchImages', 'hatch images', hatchImages, HATCH_IMAGES);
    assertHatchImages(hatchImages);
    return TonalArtMap.of(hatchImages, undefined, false);
  }

  /**
   * Loads a map that was written by `save`, or images that an artist has drawn, one PNG per tone. To an artist's images, blank
   * paper is added as the lightest tone if it is missing, and the other levels are made (see docs/maps.md). There may be up to 64
   * tones, whose finest levels together have up to 2²⁶ texels.
   *
   * @param source the URL of the JSON file of a map; or the URLs of images, lightest first; or files, for example dropped ones:
   *   all files of a map, or images in any order, which are then sorted by darkness
   * @throws Error (as a rejection) that names the missing or wrong file and the remedy; the signal's reason when aborted
   */
  static async load(source: TonalArtMapSource, options: TaskOptions = {}): Promise<TonalArtMap> {
    checkOptions('TonalArtMap.load', options);
    const { signal, onProgress } = options;
    signal?.throwIfAborted();
    const onRead = (progress: number): void => onProgress?.(READING_SHARE * progress);
    const { readSource } = await import('../../strokes/mapFiles/readSource.js');
    const { lacksLevels, thresholds, ...read } = await readSource(source, signal, onRead);
    signal?.throwIfAborted();
    assertHatchImages(read);
    if (thresholds) {
      const levels = thresholds.map((field, level) => encodeThresholds(read.size >> level, field));
      onProgress?.(1);
      return TonalArtMap.of(read, levels, true);
    }
    const { thresholds: levels, ...images } = await runTask(
      'completeHatchImages',
      { ...read, lacksLevels },
      { ...options, onProgress: onProgress && ((done) => onProgress(READING_SHARE + (1 - READING_SHARE) * done)) },
      async () => ({ ...(await readSource(source, signal, () => {})), lacksLevels }),
    );
    return TonalArtMap.of({ ...images, strokeTexels: read.strokeTexels }, levels, false);
  }

  /** Whether the map is drawn. */
  get isReady(): boolean {
    return this.content !== undefined;
  }

  /**
   * Resolves with the map itself when it is drawn. Rejects if it cannot be drawn, or with the signal's reason when aborted; if nobody
   * reads this promise, the failure is written to the console.
   */
  get ready(): Promise<TonalArtMap> {
    this.hasListener = true;
    this.drawn ??= Promise.resolve(this);
    return this.drawn;
  }

  /** The report of how well the images keep the constraints of a tonal art map. It is measured on first use. */
  get report(): HatchImageReport {
    if (!this.cachedReport) {
      this.cachedReport = checkHatchImages(this.allImages());
    }
    return this.cachedReport;
  }

  /**
   * The thresholds as a texture, for techniques that blend before they compare with the tone. It holds no colours, and its levels lie
   * side by side instead of in mip levels. A texel t stands for g = 6t − 3 = Φ⁻¹(h), clamped to ±3, where h is the tone at which the
   * texel becomes ink. So g is normally distributed, and h = Φ(g). Red holds the level itself, green the next coarser level. The
   * texture is made on first use.
   */
  get thresholdTexture(): ThresholdTexture {
    this.cachedThresholdTexture ??= new ThresholdTexture(this.thresholdPairs());
    return this.cachedThresholdTexture;
  }

  /** The loss of threshold contrast by interpolation, which shaders make up for. It is measured on first use. */
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
    return unpackHatchImage(this.contentFor('image').packed[level], tone);
  }

  /**
   * A copy of the thresholds of one level: (size / 2^level)² numbers in (0, 1) in rows of growing v, uniformly distributed. At tone
   * T (0 = paper, 1 = darkest) a texel is ink if its number is below T, so {threshold < T} is an image of mean ink T. In a
   * generated map the thresholds were drawn; for your own images they are derived from the images.
   *
   * @throws RangeError if there is no such level
   */
  thresholds(level: number): Float32Array {
    this.assertLevel('thresholds', level);
    return this.thresholdMap()[level].thresholds.slice();
  }

  /**
   * Writes the map as files: `map.json` and the PNG images that it names, one per tone and level. `load` restores exactly the same
   * map from them, including the thresholds.
   */
  async save(): Promise<File[]> {
    const { hasDrawnThresholds } = this.contentFor('save');
    const thresholds = hasDrawnThresholds ? this.thresholdMap().map((level) => level.thresholds) : undefined;
    const { writeMapFiles } = await import('../../strokes/mapFiles/writeMapFiles.js');
    const files = await writeMapFiles(this.allImages(), thresholds);
    return files.map(({ name, bytes }) => {
      const type = name.endsWith('.json') ? 'application/json' : 'image/png';
      return new File([bytes as Uint8Array<ArrayBuffer>], name, { type });
    });
  }

  /**
   * Frees the GPU memory of the textures; if a material still uses the map, they are uploaded again. A map that is still being drawn
   * has no GPU memory and becomes ready all the same; abort its signal to stop it.
   */
  dispose(): void {
    this.texture.dispose();
    this.cachedThresholdTexture?.dispose();
  }

  private fill(images: HatchImages, thresholds: ThresholdLevel[] | undefined, hasDrawnThresholds: boolean): this {
    const packed = packHatchImages(this.size, images.images);
    this.texture.fill(packed);
    this.content = { packed, thresholds, hasDrawnThresholds };
    return this;
  }

  private contentFor(member: string): MapContent {
    if (this.content) return this.content;
    throw new Error(`TonalArtMap.${member}: the map is not drawn yet; await its ready first.`);
  }

  private thresholdMap(): ThresholdLevel[] {
    const content = this.contentFor('thresholds');
    if (content.thresholds) return content.thresholds;
    content.thresholds = runToEnd(deriveThresholds(this.allImages()));
    return content.thresholds;
  }

  private thresholdPairs(): ThresholdPair[] {
    this.pairs ??= pairThresholdLevels(this.thresholdMap());
    return this.pairs;
  }

  private allImages(): HatchImages {
    const images = Array.from({ length: this.tones }, (_, tone) =>
      Array.from({ length: this.levels }, (_, level) => this.image(tone, level)),
    );
    return { size: this.size, images, strokeTexels: this.strokeTexels };
  }

  private assertLevel(method: string, level: number): void {
    if (Number.isInteger(level) && level >= 0 && level < this.levels) return;
    throw new RangeError(
      `TonalArtMap.${method}: level is ${level}, but must be a whole number from 0 to ${this.levels - 1}.`,
    );
  }
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
