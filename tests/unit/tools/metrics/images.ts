import type { SurfaceImage } from '../../../../tools/metrics/measures/SurfaceImage.js';

/** A picture that is surface everywhere, from a luminance per pixel. */
export function picture(
  width: number,
  height: number,
  luminance: (x: number, y: number) => number,
  isSurface: (x: number, y: number) => boolean = () => true,
): SurfaceImage {
  const each = <T>(f: (x: number, y: number) => T) =>
    Array.from({ length: width * height }, (_, i) => f(i % width, Math.floor(i / width)));
  return {
    width,
    height,
    luminance: Float32Array.from(each(luminance)),
    surface: Uint8Array.from(each((x, y) => (isSurface(x, y) ? 255 : 0))),
  };
}

/** Black stripes at a distance `spacing`, whose normal makes `angle` with the rows, covering `tone` of the picture. */
export function stripes(size: number, spacing: number, angle: number, tone = 0.5, shift = 0): SurfaceImage {
  return picture(size, size, (x, y) => {
    const phase = (x * Math.cos(angle) + y * Math.sin(angle) + shift) / spacing;
    return phase - Math.floor(phase) < tone ? 0 : 1;
  });
}

/** Reproducible numbers in [0, 1). */
export function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
