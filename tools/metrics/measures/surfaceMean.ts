import type { SurfaceImage } from './SurfaceImage.js';

/** The mean of a function of luminance over all pixels that show the surface. */
export function surfaceMean({ luminance, surface }: SurfaceImage, value: (luminance: number) => number): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < luminance.length; i++) {
    if (surface[i] === 0) continue;
    count++;
    sum += value(luminance[i]);
  }
  return sum / count;
}
