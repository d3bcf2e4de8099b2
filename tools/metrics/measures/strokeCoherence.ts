import type { SurfaceImage } from './SurfaceImage.js';
import { structureTensor } from './structureTensor.js';

/**
 * The agreement of neighbouring strokes in direction: the coherence (λ₁ − λ₂)/(λ₁ + λ₂) of the structure tensor of the picture,
 * averaged with the contrast λ₁ + λ₂ as weight. 1 for straight lines, near 0 for noise and for crossed lines.
 */
export function strokeCoherence(image: SurfaceImage): number {
  const { xx, xy, yy } = structureTensor(image);
  let [difference, sum] = [0, 0];
  for (let i = 0; i < xx.length; i++) {
    if (image.surface[i] === 0) continue;
    difference += Math.hypot(xx[i] - yy[i], 2 * xy[i]);
    sum += xx[i] + yy[i];
  }
  return difference / sum;
}
