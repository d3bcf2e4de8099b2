import { encodeThresholds, type ThresholdLevel } from './encodeThresholds.js';
import type { HatchImages } from './generateHatchImages.js';
import { orderOf } from './orderOf.js';

/** Ever more blurred copies of the field, by the texels over which each is blurred further, and what each counts. */
const BLURS = [
  { radius: 0, weight: 1 },
  { radius: 1, weight: 1 },
  { radius: 3, weight: 0.1 },
  { radius: 9, weight: 0.02 },
] as const;

/**
 * Derives thresholds from hatch images, level by level: the darker a texel over all tones, the earlier it becomes ink.
 *
 * Images say this in steps of tone only. A slight blur turns steps into slopes, so that strokes swell and can be magnified;
 * wider ones, which count less, order what is equal for the narrower: blank paper by its distance from strokes, solid ink
 * by its depth.
 */
export function deriveThresholds({ size, images }: HatchImages): ThresholdLevel[] {
  return images[0].map((_, level) => {
    const side = size >> level;
    const order = orderOf(smoothed(meanPaper(images, level), side));
    const thresholds = new Float32Array(order.length);
    for (let rank = 0; rank < order.length; rank++) thresholds[order[rank]] = (rank + 0.5) / order.length;
    return encodeThresholds(side, thresholds);
  });
}

/** The mean over all tones of what is paper: 0 where all are ink, 1 where none is. */
function meanPaper(images: readonly (readonly Uint8Array[])[], level: number): Float32Array {
  const mean = new Float32Array(images[0][level].length);
  for (const row of images) {
    const image = row[level];
    for (let i = 0; i < mean.length; i++) mean[i] += image[i] / (255 * images.length);
  }
  return mean;
}

/** The weighted sum of ever more blurred copies of a toroidal field. */
function smoothed(field: Float32Array, size: number): Float32Array {
  const sum = new Float32Array(field.length);
  let blurred = field;
  for (const { radius, weight } of BLURS) {
    blurred = blurRows(blurRows(blurred, size, radius), size, radius);
    for (let i = 0; i < sum.length; i++) sum[i] += weight * blurred[i];
  }
  return sum;
}

/**
 * Blurs the rows of a toroidal field by a tent of 2·radius + 1 texels, and transposes it, so that applying it twice blurs
 * both ways. The tent sums to one.
 */
function blurRows(field: Float32Array, size: number, radius: number): Float32Array {
  const mask = size - 1;
  const result = new Float32Array(field.length);
  const scale = 1 / ((radius + 1) * (radius + 1));
  for (let row = 0; row < size; row++) {
    const start = row * size;
    for (let column = 0; column < size; column++) {
      let sum = 0;
      for (let offset = -radius; offset <= radius; offset++) {
        sum += (radius + 1 - Math.abs(offset)) * field[start + ((column + offset) & mask)];
      }
      result[column * size + row] = sum * scale;
    }
  }
  return result;
}
