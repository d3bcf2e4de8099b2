import { blurToroidal } from '../blurToroidal.js';
import { equalize } from '../ranking.js';
import { encodeThresholds, type ThresholdLevel } from './encodeThresholds.js';
import type { HatchImages } from './HatchImages.js';

/** The field is blurred repeatedly: the radius of each further blur in texels, and the weight of its result. */
const BLURS = [
  { radius: 0, weight: 1 },
  { radius: 1, weight: 1 },
  { radius: 3, weight: 0.1 },
  { radius: 9, weight: 0.02 },
] as const;

/**
 * Derives thresholds from hatch images, level by level: the darker a texel is over all tones, the earlier it becomes ink.
 *
 * The images alone give thresholds in steps of tone. A slight blur turns the steps into slopes, so that strokes swell and can be
 * magnified. Wider blurs with less weight give an order to texels that are still equal: blank paper by its distance from strokes,
 * solid ink by its distance from the edge.
 *
 * @returns the levels, the finest first; yields progress in [0, 1]
 */
export function* deriveThresholds({ size, images }: HatchImages): Generator<number, ThresholdLevel[], void> {
  const levels: ThresholdLevel[] = [];
  for (let level = 0; level < images[0].length; level++) {
    const side = size >> level;
    levels.push(encodeThresholds(side, equalize(smoothed(meanPaper(images, level), side))));
    yield 1 - 1 / 4 ** (level + 1);
  }
  return levels;
}

/** The mean over all tones, per texel: 0 where all tones are ink, 1 where all are paper. */
function meanPaper(images: readonly (readonly Uint8Array[])[], level: number): Float32Array {
  const mean = new Float32Array(images[0][level].length);
  for (const row of images) {
    const image = row[level];
    for (let i = 0; i < mean.length; i++) mean[i] += image[i] / (255 * images.length);
  }
  return mean;
}

/** The weighted sum of successive blurs of a toroidal field. */
function smoothed(field: Float32Array, size: number): Float32Array {
  const sum = new Float32Array(field.length);
  let blurred = field;
  for (const { radius, weight } of BLURS) {
    blurred = blurToroidal(blurred, size, radius);
    for (let i = 0; i < sum.length; i++) sum[i] += weight * blurred[i];
  }
  return sum;
}
