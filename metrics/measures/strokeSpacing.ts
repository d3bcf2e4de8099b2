import { isInk, type SurfaceImage } from './SurfaceImage.js';

/** Side of the windows strokes are taken to run straight in, in pixels. */
const WINDOW = 16;

/**
 * M7: the mean distance between strokes in pixels, across them.
 *
 * Straight strokes at a distance s whose normal makes an angle φ with a line of pixels are entered or left 2·|cos φ|/s
 * times per pixel of that line. Rows and columns together give 2/s whatever φ is, as the root of the sum of the squares; taken
 * in windows that lie wholly on the surface, and averaged.
 */
export function strokeSpacing({ width, height, luminance, surface }: SurfaceImage): number {
  let density = 0;
  let windows = 0;
  for (let top = 0; top + WINDOW < height; top += WINDOW) {
    for (let left = 0; left + WINDOW < width; left += WINDOW) {
      let [alongRows, alongColumns] = [0, 0];
      let whole = true;
      for (let y = top; y <= top + WINDOW && whole; y++) {
        for (let x = left; x <= left + WINDOW; x++) {
          const i = y * width + x;
          if (surface[i] === 0) {
            whole = false;
            break;
          }
          const ink = isInk(luminance[i]);
          if (x > left && y > top && ink !== isInk(luminance[i - 1])) alongRows++;
          if (x > left && y > top && ink !== isInk(luminance[i - width])) alongColumns++;
        }
      }
      if (!whole) continue;
      windows++;
      density += Math.hypot(alongRows, alongColumns) / (WINDOW * WINDOW);
    }
  }
  return (2 * windows) / density;
}

/** How far values stray from their middle: half of what lies between smallest and largest, over the mean of the two. */
export function halfSpread(values: readonly number[]): number {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return (most - least) / (most + least);
}
