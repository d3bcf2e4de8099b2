import type { SurfaceImage } from './SurfaceImage.js';
import { surfaceMean } from './surfaceMean.js';

/**
 * M1: the share of surface pixels that are neither ink nor paper: luminance strictly between 0.2 and 0.8. Needs a picture
 * without antialiasing, so that every grey pixel was drawn grey.
 */
export const greyness = (image: SurfaceImage): number =>
  surfaceMean(image, (luminance) => (luminance > 0.2 && luminance < 0.8 ? 1 : 0));
