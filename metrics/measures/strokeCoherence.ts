import type { SurfaceImage } from './SurfaceImage.js';

/** Standard deviations in pixels: of the smoothing before gradients are taken, and of the window of the structure tensor. */
const GRADIENT_SIGMA = 1;
const NEIGHBOURHOOD_SIGMA = 4;

/**
 * How well neighbouring strokes agree in direction: the coherence (λ₁ − λ₂)/(λ₁ + λ₂) of the structure tensor of the picture,
 * averaged with the contrast λ₁ + λ₂ as weight. 1 for straight lines, near 0 for noise and for crossed lines.
 */
export function strokeCoherence({ width, height, luminance, surface }: SurfaceImage): number {
  const mask = Float32Array.from(surface, (s) => (s === 0 ? 0 : 1));
  const covered = blur(mask, width, height, GRADIENT_SIGMA);
  const light = blur(
    luminance.map((l, i) => l * mask[i]),
    width,
    height,
    GRADIENT_SIGMA,
  );

  const xx = new Float32Array(light.length);
  const xy = new Float32Array(light.length);
  const yy = new Float32Array(light.length);
  for (let y = 1; y + 1 < height; y++) {
    for (let x = 1; x + 1 < width; x++) {
      const i = y * width + x;
      // Near the outline, smoothing has mixed in the background: gradients there are not strokes.
      if ([i, i - 1, i + 1, i - width, i + width].some((j) => covered[j] < 0.9999)) continue;
      const dx = (light[i + 1] - light[i - 1]) / 2;
      const dy = (light[i + width] - light[i - width]) / 2;
      xx[i] = dx * dx;
      xy[i] = dx * dy;
      yy[i] = dy * dy;
    }
  }
  const [jxx, jxy, jyy] = [xx, xy, yy].map((part) => blur(part, width, height, NEIGHBOURHOOD_SIGMA)) as [
    Float32Array,
    Float32Array,
    Float32Array,
  ];
  let [difference, sum] = [0, 0];
  for (let i = 0; i < jxx.length; i++) {
    if (surface[i] === 0) continue;
    difference += Math.hypot(jxx[i] - jyy[i], 2 * jxy[i]);
    sum += jxx[i] + jyy[i];
  }
  return difference / sum;
}

/** Gaussian smoothing of the rows, then of the columns. Zero outside the picture. */
function blur(source: Float32Array, width: number, height: number, sigma: number): Float32Array {
  const radius = Math.ceil(3 * sigma);
  const kernel = Array.from({ length: 2 * radius + 1 }, (_, k) => Math.exp(-0.5 * ((k - radius) / sigma) ** 2));
  const total = kernel.reduce((sum, weight) => sum + weight, 0);
  const pass = (from: Float32Array, length: number, step: number, lines: number, lineStep: number) => {
    const to = new Float32Array(from.length);
    for (let line = 0; line < lines; line++) {
      for (let at = 0; at < length; at++) {
        let value = 0;
        for (let k = Math.max(-radius, -at); k <= Math.min(radius, length - 1 - at); k++) {
          value += kernel[k + radius] * from[line * lineStep + (at + k) * step];
        }
        to[line * lineStep + at * step] = value / total;
      }
    }
    return to;
  };
  return pass(pass(source, width, 1, height, width), height, width, width, 1);
}
