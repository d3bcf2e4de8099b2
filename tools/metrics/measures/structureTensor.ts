import type { SurfaceImage } from './SurfaceImage.js';

/** Standard deviations in pixels: of the smoothing before gradients are taken, and of the window of the structure tensor. */
const GRADIENT_SIGMA = 1;
const NEIGHBOURHOOD_SIGMA = 4;

/** Σ ∇L ∇Lᵀ of the luminance around every pixel. */
export interface StructureTensor {
  readonly xx: Float32Array;
  readonly xy: Float32Array;
  readonly yy: Float32Array;
}

/** The structure tensor of a picture, of gradients that are wholly on the surface. */
export function structureTensor({ width, height, luminance, surface }: SurfaceImage): StructureTensor {
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
  const around = (part: Float32Array) => blur(part, width, height, NEIGHBOURHOOD_SIGMA);
  return { xx: around(xx), xy: around(xy), yy: around(yy) };
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
