import { expect } from '../browser/test.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';

export interface PictureError {
  /** Mean over pixels of the error of the worst channel, of 255. */
  mean: number;
  /** Share of pixels whose worst channel is off by at most 4 of 255. */
  share: number;
  /** Number of values in the picture. */
  values: number;
}

/** The error of an RGBA picture, compared with the reference at some of its pixels. */
export function pictureError(pixels: ArrayLike<number>, reference: ReadonlyMap<number, Vec3>): PictureError {
  let sum = 0;
  let near = 0;
  const values = new Set<number>();
  for (const [pixel, rgb] of reference) {
    let worst = 0;
    for (let channel = 0; channel < 3; channel++) {
      const actual = pixels[4 * pixel + channel];
      values.add(actual);
      worst = Math.max(worst, Math.abs(actual - 255 * rgb[channel]));
    }
    sum += worst;
    if (worst <= 4) near++;
  }
  return { mean: sum / reference.size, share: near / reference.size, values: values.size };
}

/** Asserts the limits of every comparison with the reference. */
export function expectEqualPictures({ mean, share, values }: PictureError): void {
  expect(values, 'a picture of more than one colour').toBeGreaterThan(2);
  expect(mean, 'mean absolute error of 255').toBeLessThanOrEqual(0.75);
  expect(share, 'share of pixels within 4/255').toBeGreaterThanOrEqual(0.99);
}

/** For the report. */
export const describeError = ({ mean, share }: PictureError): { type: string; description: string } => ({
  type: 'error',
  description: `mean ${mean.toFixed(3)}/255, ${(100 * share).toFixed(2)} % within 4/255`,
});
