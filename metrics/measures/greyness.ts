import type { SurfaceImage } from './SurfaceImage.js';

/**
 * M1: the share of surface pixels that are neither ink nor paper, with luminance strictly between 0.2 and 0.8. To be taken
 * from a picture without antialiasing, where whatever is grey was drawn grey.
 */
export function greyness({ luminance, surface }: SurfaceImage): number {
  let grey = 0;
  let all = 0;
  for (let i = 0; i < luminance.length; i++) {
    if (surface[i] === 0) continue;
    all++;
    if (luminance[i] > 0.2 && luminance[i] < 0.8) grey++;
  }
  return grey / all;
}
