import { asPhase } from '../../mesh/phases.js';
import { equalize } from '../ranking.js';
import { meanInk } from './checkHatchImages.js';
import type { HatchImages } from './HatchImages.js';
import { COARSEST_SIZE } from './hatchImageOptions.js';
import { deriveThresholds, type ThresholdLevel } from './thresholds.js';

/**
 * Makes the missing levels of images that have only one, each with half the texels per side, down to 16.
 *
 * Ordinary downsampling would make strokes grey and thin. Instead, the order in which texels become ink (`deriveThresholds`) is
 * filtered by a minimum over 3 × 3 texels and then downsampled, so that strokes of about two texels keep their width in texels. In
 * this order, texels become ink until the image has the mean of its tone. So the strokes of light tones stay, and later strokes
 * appear only in darker tones. All are black, and they nest in tone and level.
 *
 * @param images `images[tone][0]`; they are not changed
 * @returns the images with all their levels; yields progress in [0, 1]
 */
export function* makeLevels({ size, images }: HatchImages): Generator<number, HatchImages, void> {
  const result = images.map(([finest]) => [finest]);
  if (size <= COARSEST_SIZE) return { size, images: result };
  const means = images.map(([finest]) => meanInk(finest));
  // If a tone were lighter than a previous one, its levels would not nest.
  for (let tone = 1; tone < means.length; tone++) means[tone] = Math.max(means[tone], means[tone - 1]);
  let [{ thresholds }] = yield* deriveThresholds({ size, images: result });
  for (let side = size; side > COARSEST_SIZE; side /= 2) {
    thresholds = equalize(downsample(minimumFilter(thresholds, side), side));
    const steepness = steepnessOf(thresholds, side / 2);
    for (const [tone, row] of result.entries()) row.push(drawMean(thresholds, steepness, means[tone]));
    yield 1;
  }
  return { size, images: result };
}

/** For every texel the minimum of it and the eight texels around it. */
function minimumFilter(field: Float32Array, size: number): Float32Array {
  const mask = size - 1;
  const result = new Float32Array(field.length);
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      let least = Number.POSITIVE_INFINITY;
      for (let y = row - 1; y <= row + 1; y++) {
        for (let x = column - 1; x <= column + 1; x++) {
          least = Math.min(least, field[(y & mask) * size + (x & mask)]);
        }
      }
      result[row * size + column] = least;
    }
  }
  return result;
}

/** Halves the texels per side: each becomes the mean of 2 × 2 texels. */
function downsample(field: Float32Array, size: number): Float32Array {
  const half = size / 2;
  const result = new Float32Array(half * half);
  for (let row = 0; row < half; row++) {
    for (let column = 0; column < half; column++) {
      const at = 2 * row * size + 2 * column;
      result[row * half + column] = (field[at] + field[at + 1] + field[at + size] + field[at + size + 1]) / 4;
    }
  }
  return result;
}

/** The change of the field per texel at each place, in the steeper of the two directions. */
function steepnessOf(field: Float32Array, size: number): Float32Array {
  const mask = size - 1;
  return field.map((_, i) => {
    const [row, column] = [Math.floor(i / size), i & mask];
    const at = (y: number, x: number): number => field[(y & mask) * size + (x & mask)];
    return (
      0.5 *
      Math.max(Math.abs(at(row, column + 1) - at(row, column - 1)), Math.abs(at(row + 1, column) - at(row - 1, column)))
    );
  });
}

/** Draws an image of the given mean ink, whose edges are one texel soft. */
function drawMean(thresholds: Float32Array, steepness: Float32Array, mean: number): Uint8Array {
  const image = new Uint8Array(thresholds.length).fill(255);
  if (mean === 0) return image;
  for (let i = 0; i < image.length; i++) {
    const ink = (mean - thresholds[i]) / Math.max(steepness[i], 1e-6) + 0.5;
    image[i] = 255 - Math.round(255 * Math.max(0, Math.min(1, ink)));
  }
  return image;
}

/** Hatch images with all levels, and the thresholds. */
export interface CompleteHatchImages extends HatchImages {
  thresholds: ThresholdLevel[];
}

/** Makes the levels of images that lack them, and derives the thresholds. Yields progress in [0, 1]. */
export function* completeHatchImages({
  lacksLevels,
  ...given
}: HatchImages & { lacksLevels: boolean }): Generator<number, CompleteHatchImages, void> {
  const { size, images } = lacksLevels ? yield* asPhase(makeLevels(given), 0, 0.5) : given;
  const thresholds = yield* asPhase(deriveThresholds({ size, images }), lacksLevels ? 0.5 : 0, 1);
  return { size, images, thresholds };
}
