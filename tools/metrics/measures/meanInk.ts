import type { SurfaceImage } from './SurfaceImage.js';
import { surfaceMean } from './surfaceMean.js';

/** The mean darkness of the surface. M4, the tone error, is its distance from the tone that the whole surface should have. */
export const meanInk = (image: SurfaceImage): number => surfaceMean(image, (luminance) => 1 - luminance);
