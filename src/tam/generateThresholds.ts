import { drawThresholdField } from './drawThresholdField.js';
import { encodeThresholds, type ThresholdLevel } from './encodeThresholds.js';
import { type HatchImageOptions, type HatchImageRequest, resolveHatchImageOptions } from './generateHatchImages.js';
import { orderOf } from './orderOf.js';
import { placeStrokes } from './placeStrokes.js';
import { rasterizeStroke } from './rasterizeStroke.js';
import type { Stroke } from './Stroke.js';

/** Strokes are placed in so many steps of tone: enough for an even drawing at any tone in between. */
const STEPS = 24;

/** Cells of the field per texel and side; a texel holds their mean. */
const CELLS_PER_TEXEL = 2;

/** Cells visited between two reports of progress: about a millisecond's work. */
const WORK_PER_SLICE = 300_000;

/** Progress when the strokes are placed. */
const PLACED = 0.8;

/**
 * Draws the thresholds of a tonal art map: for each level one image of the tones from which on its texels are ink. The
 * set {threshold < tone} is a drawing of exactly that mean ink, for every tone; as tone rises, strokes appear between those
 * that are there, grow longer and swell, until thin lines of paper remain and close.
 *
 * "The tone at which a texel becomes ink" is Webb et al.'s threshold scheme (2002), drawn with distance profiles instead
 * of steps so that it can be interpolated, and equalised so that coverage equals tone. Texel [i][j] equals texel
 * [size−1−i][size−1−j], so that a direction of strokes and its opposite draw the same. Strokes of a level are those of the
 * next coarser one and new ones between them.
 *
 * @throws RangeError if an option is out of its range, at the first step. `tones` does not matter.
 * @returns the levels, finest first; yields progress in [0, 1]
 */
export function* generateThresholds(options: HatchImageOptions = {}): Generator<number, ThresholdLevel[], void> {
  const request = resolveHatchImageOptions(options);
  const style = { ...request.style, maxInk: request.style.maxStrokes };
  const placing = placeStrokes({ ...request, style, tones: STEPS + 1, pairs: true });
  let step = placing.next();
  for (; !step.done; step = placing.next()) yield PLACED * step.value;
  const strokes = step.value;
  const levels: ThresholdLevel[] = [];
  for (let level = 0; level < request.levels; level++) {
    levels.push(yield* drawLevel(strokes, level, request));
  }
  return levels;
}

/** One level of thresholds. Its field is drawn from every other stroke and completed by symmetry. */
function* drawLevel(
  strokes: Stroke[],
  level: number,
  request: HatchImageRequest,
): Generator<number, ThresholdLevel, void> {
  const size = request.size >> level;
  const progress = PLACED + (1 - PLACED) * (1 - 1 / 4 ** (level + 1));
  const image = new Uint8Array(size * size).fill(255);
  const cells = size * CELLS_PER_TEXEL;
  const field = new Float32Array(cells * cells).fill(Number.MAX_VALUE);
  let darkness = 0;
  let work = 0;
  for (let i = 0; i < strokes.length; i += 2) {
    const stroke = strokes[i];
    if (stroke.level < level) continue;
    darkness += rasterizeStroke(image, size, stroke) + rasterizeStroke(image, size, strokes[i + 1]);
    work += drawThresholdField(field, size, CELLS_PER_TEXEL, stroke, darkness / (255 * size * size));
    if (work >= WORK_PER_SLICE) {
      work = 0;
      yield progress;
    }
  }
  const half = averageHalf(field, size);
  yield progress;
  const order = orderOf(half);
  yield progress;
  const thresholds = new Float32Array(size * size);
  const last = thresholds.length - 1;
  for (let rank = 0; rank < order.length; rank++) {
    const threshold = (rank + 0.5) / order.length;
    thresholds[order[rank]] = threshold;
    thresholds[last - order[rank]] = threshold;
  }
  yield progress;
  return encodeThresholds(size, thresholds);
}

/** Means of the cells of each texel in the first half of the rows, of the lower of the field and its half turn. */
function averageHalf(field: Float32Array, size: number): Float32Array {
  const cells = size * CELLS_PER_TEXEL;
  const last = field.length - 1;
  const half = new Float32Array((size * size) / 2);
  for (let texel = 0; texel < half.length; texel++) {
    const corner = Math.floor(texel / size) * CELLS_PER_TEXEL * cells + (texel % size) * CELLS_PER_TEXEL;
    let sum = 0;
    for (let row = 0; row < CELLS_PER_TEXEL; row++) {
      for (let column = 0; column < CELLS_PER_TEXEL; column++) {
        const cell = corner + row * cells + column;
        sum += Math.min(field[cell], field[last - cell]);
      }
    }
    half[texel] = sum / CELLS_PER_TEXEL ** 2;
  }
  return half;
}
