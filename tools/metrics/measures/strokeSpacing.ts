import { isInk, type SurfaceImage } from './SurfaceImage.js';

/** Side in pixels of the windows within which strokes are taken as straight. */
const WINDOW = 16;

/**
 * M7: the mean distance between strokes in pixels, across them.
 *
 * Take straight strokes at a distance s whose normal makes an angle φ with a line of pixels. That line crosses 2·|cos φ|/s stroke
 * edges per pixel. For rows and columns together, the root of the sum of squares is 2/s for any φ. It is measured in windows
 * that lie wholly on the surface, and averaged.
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

/** Half the range of the values, divided by the middle of the range. */
export function halfSpread(values: readonly number[]): number {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return (most - least) / (most + least);
}
