import type { Hand } from '../hand/Hand.js';
import { STROKE_WIDTHS, type StrokeStyleName } from '../strokeStyleNames.js';

/** Texels per side of the coarsest level of a map. On a smaller level, strokes would be as wide as long. */
export const COARSEST_SIZE = 16;

/** The options that determine a generated map. */
export interface MapDrawing {
  /** The style of the strokes. Default `'hatching'`. */
  style?: StrokeStyleName | undefined;
  /** A person's hand, whose strokes replace those of a style. */
  hand?: Hand | undefined;
  /** A whole number. Each seed places the strokes differently; the same seed gives the same bytes. Default 1. */
  seed?: number | undefined;
  /** Texels per side of the finest level: a power of two from 64 to 1024. Default 256. */
  size?: number | undefined;
  /** Number of tones including blank paper, 4 to 16. Default 8. */
  tones?: number | undefined;
  /** Number of levels. The default is the maximum: all levels from `size` down to 16 texels. */
  levels?: number | undefined;
  /**
   * Width of a stroke or diameter of a dot in texels, the same on every level. Default and range depend on the style: for pen
   * strokes 1.9 in the range 1.2 to 2.6, for dots 2.4 in the range 1.65 to 2.5. A hand is drawn at the scale at which its own width
   * becomes this one.
   */
  strokeTexels?: number | undefined;
}

/** The options with all defaults filled in. */
export interface FullMapDrawing {
  style: StrokeStyleName;
  strokeTexels: number;
  seed: number;
  size: number;
  tones: number;
  levels: number;
}

/**
 * Fills in defaults and checks ranges.
 *
 * @param caller the function named in the error
 * @throws RangeError that names the option and its range
 */
export function resolveMapDrawing(
  options: Omit<MapDrawing, 'hand'> & { hand?: object | undefined } = {},
  caller = 'TonalArtMap.generate',
): FullMapDrawing {
  const fail = (option: keyof MapDrawing, value: unknown, allowed: string): never => {
    throw new RangeError(`${caller}: ${option} is ${String(value)}, but must be ${allowed}.`);
  };
  const { style = 'hatching', hand, seed = 1, size = 256, tones = 8 } = options;
  // The content of a hand is checked when its strokes are prepared.
  if (hand && options.style) fail('style', style, 'left out beside a hand');
  if (!Object.hasOwn(STROKE_WIDTHS, style)) {
    fail('style', style, `one of ${Object.keys(STROKE_WIDTHS).join(', ')}`);
  }
  if (!Number.isSafeInteger(seed)) fail('seed', seed, 'a whole number');
  if (![64, 128, 256, 512, 1024].includes(size)) fail('size', size, '64, 128, 256, 512 or 1024');
  if (!Number.isInteger(tones) || tones < 4 || tones > 16) fail('tones', tones, 'a whole number from 4 to 16');
  const allLevels = Math.log2(size / COARSEST_SIZE) + 1;
  const levels = options.levels ?? allLevels;
  if (!Number.isInteger(levels) || levels < 1 || levels > allLevels) {
    fail('levels', levels, `a whole number from 1 to ${allLevels} at size ${size}, or left out`);
  }
  // A hand has the widths of the default style.
  const { width, widthRange } = STROKE_WIDTHS[style];
  const { strokeTexels = width } = options;
  const [narrowest, widest] = widthRange;
  if (!(strokeTexels >= narrowest && strokeTexels <= widest)) {
    fail(
      'strokeTexels',
      strokeTexels,
      `a number from ${narrowest} to ${widest} texels for ${hand ? 'a hand' : `style ${style}`}`,
    );
  }
  return { style, strokeTexels, seed, size, tones, levels };
}
