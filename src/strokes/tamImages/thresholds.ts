import { blurToroidal } from '../blurToroidal.js';
import { equalize } from '../ranking.js';
import type { HatchImages } from './HatchImages.js';

/** The thresholds of one level, as numbers and encoded. */
export interface ThresholdLevel {
  /** Texels per side. */
  size: number;
  /** size² numbers in (0, 1), in rows of growing v: the tones at which the texels become ink. They are uniformly distributed. */
  thresholds: Float32Array;
  /** g = Φ⁻¹(threshold) as bytes, 0 for −3 and 255 for 3: normally distributed. The content of the texture. */
  encoded: Uint8Array;
}

/** g is clamped at this many standard deviations. The 0.13 % of the texels beyond become ink all at once. */
export const LIMIT = 3;

/** Φ⁻¹(p), the quantile of the standard normal distribution, to 5e-4 (Abramowitz and Stegun 1964, 26.2.23). */
export function normalQuantile(p: number): number {
  if (p > 0.5) return -normalQuantile(1 - p);
  const t = Math.sqrt(-2 * Math.log(p));
  const numerator = 2.515517 + t * (0.802853 + t * 0.010328);
  const denominator = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
  return numerator / denominator - t;
}

/**
 * Encodes thresholds for the texture. Bytes are precise enough, because edges lie between texels, where the texture unit
 * interpolates. Half floats would take a software rasterizer a third of the frame time.
 */
export function encodeThresholds(size: number, thresholds: Float32Array): ThresholdLevel {
  const encoded = new Uint8Array(thresholds.length);
  for (let i = 0; i < thresholds.length; i++) {
    const g = Math.max(-LIMIT, Math.min(LIMIT, normalQuantile(thresholds[i])));
    // Rounding away from the middle keeps a threshold and its complement symmetric.
    encoded[i] = g < 0 ? Math.ceil(127.5 * (1 + g / LIMIT) - 0.5) : Math.floor(127.5 * (1 + g / LIMIT) + 0.5);
  }
  return { size, thresholds, encoded };
}

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
