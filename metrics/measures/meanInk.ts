import type { SurfaceImage } from './SurfaceImage.js';

/** The mean darkness of the surface; M4 is its distance from the tone that was asked for everywhere. */
export function meanInk({ luminance, surface }: SurfaceImage): number {
  let ink = 0;
  let all = 0;
  for (let i = 0; i < luminance.length; i++) {
    if (surface[i] === 0) continue;
    all++;
    ink += 1 - luminance[i];
  }
  return ink / all;
}
