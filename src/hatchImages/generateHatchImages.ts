import { type PaperTooth, paperTooth } from '../strokes/paperTooth.js';
import { placeStrokes } from '../strokes/placeStrokes.js';
import { rasterizeStroke } from '../strokes/rasterizeStroke.js';
import type { Stroke } from '../strokes/Stroke.js';
import { type StrokeStyle, type StrokeStyleName, strokeStyles } from '../strokes/strokeStyles.js';
import { nestLevels } from './nestLevels.js';

/** What `TonalArtMap.generate` draws. */
export interface HatchImageOptions {
  /** The hand. Default `'hatching'`. */
  style?: StrokeStyleName | undefined;
  /** Another whole number gives another drawing of the same kind; the same one gives the same bytes. Default 1. */
  seed?: number | undefined;
  /** Texels per side of the finest level: a power of two from 64 to 1024. Default 256. */
  size?: number | undefined;
  /** Number of tones with blank paper, 4 to 16. Default 8. */
  tones?: number | undefined;
  /** Number of levels. Default and maximum: all from `size` down to 16 texels. */
  levels?: number | undefined;
  /**
   * Width of a stroke or diameter of a dot in texels, the same on every level. Its default and its range depend on the
   * style: 1.9 of 1.2 to 2.6 for pen strokes, 2.4 of 1.65 to 2.5 for dots.
   */
  strokeWidth?: number | undefined;
}

/** Hatch images as bytes, 255 = paper, 0 = ink. */
export interface HatchImages {
  /** Texels per side of level 0. */
  size: number;
  /**
   * `images[tone][level]`: (size / 2^level)² bytes in rows of growing v, strokes along u. Image k of n stands for tone
   * k/(n−1); image 0 is the lightest.
   */
  images: Uint8Array[][];
}

/** Options with every default filled in. */
export interface HatchImageRequest {
  style: StrokeStyle;
  seed: number;
  size: number;
  tones: number;
  levels: number;
}

/** Texels per side of the coarsest level: on fewer, strokes are as long as they are wide. */
const COARSEST_SIZE = 16;

/**
 * Fills in defaults and checks ranges.
 *
 * @throws RangeError naming the option and what it may be
 */
export function resolveHatchImageOptions(options: HatchImageOptions = {}): HatchImageRequest {
  const { style: name = 'hatching', seed = 1, size = 256, tones = 8 } = options;
  if (!Object.hasOwn(strokeStyles, name)) {
    fail('style', name, `one of ${Object.keys(strokeStyles).join(', ')}`);
  }
  if (!Number.isSafeInteger(seed)) fail('seed', seed, 'a whole number');
  if (![64, 128, 256, 512, 1024].includes(size)) fail('size', size, '64, 128, 256, 512 or 1024');
  if (!Number.isInteger(tones) || tones < 4 || tones > 16) fail('tones', tones, 'a whole number from 4 to 16');
  const allLevels = Math.log2(size / COARSEST_SIZE) + 1;
  const levels = options.levels ?? allLevels;
  if (!Number.isInteger(levels) || levels < 1 || levels > allLevels) {
    fail('levels', levels, `a whole number from 1 to ${allLevels} at size ${size}, or left out`);
  }
  const style: StrokeStyle = strokeStyles[name];
  const width = options.strokeWidth ?? style.width;
  const [narrowest, widest] = style.widthRange;
  if (!(width >= narrowest && width <= widest)) {
    fail('strokeWidth', width, `a number from ${narrowest} to ${widest} texels for style ${name}`);
  }
  return { style: { ...style, width }, seed, size, tones, levels };
}

function fail(option: keyof HatchImageOptions, value: unknown, allowed: string): never {
  throw new RangeError(`TonalArtMap.generate: ${option} is ${String(value)}, but must be ${allowed}.`);
}

/**
 * Draws the hatch images of a tonal art map: every tone at every level.
 *
 * The mean ink of image k is maxInk·k/(tones−1) on every level, to within half a stroke; maxInk belongs to the style.
 * Means count ink linearly (0 = paper, 1 = ink), so they are what a renderer that mixes paper and ink in linear light
 * shows from afar.
 *
 * @throws RangeError if an option is out of its range, at the first step
 * @returns the images; yields progress in [0, 1]
 */
export function* generateHatchImages(options: HatchImageOptions = {}): Generator<number, HatchImages, void> {
  const request = resolveHatchImageOptions(options);
  const strokes = yield* placeStrokes(request);
  const teeth = Array.from({ length: request.levels }, (_, level) => paperTooth(request, level));
  const images: Uint8Array[][] = [];
  for (let tone = 0; tone < request.tones; tone++) {
    images.push(drawTone(strokes, tone, request, teeth, images.at(-1)));
    yield 1;
  }
  // Lines nest because they are drawn so; where grain breaks them up, it takes one more step.
  if (request.style.grain) nestLevels({ size: request.size, images });
  return { size: request.size, images };
}

/** All levels of one tone: those of the tone before and the strokes that are new in it. */
function drawTone(
  strokes: Stroke[],
  tone: number,
  request: HatchImageRequest,
  teeth: (PaperTooth | undefined)[],
  lighter?: Uint8Array[],
): Uint8Array[] {
  const added = strokes.filter((stroke) => stroke.tone === tone);
  return Array.from({ length: request.levels }, (_, level) => {
    const size = request.size >> level;
    const image = lighter ? lighter[level].slice() : new Uint8Array(size * size).fill(255);
    for (const stroke of added) if (stroke.level >= level) rasterizeStroke(image, size, stroke, teeth[level]);
    return image;
  });
}
