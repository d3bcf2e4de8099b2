/** Looking at pictures of the toolkit page: RGBA, bottom row first. */

export const SIZE = 96;

export const at = (pixels: number[], x: number, y: number) => pixels.slice(4 * (y * SIZE + x), 4 * (y * SIZE + x) + 3);
export const centre = (pixels: number[]) => at(pixels, SIZE / 2, SIZE / 2);
export const isGround = (rgb: number[]) => rgb[0] === 0 && rgb[1] === 255 && rgb[2] === 0;
export const covered = (pixels: number[]) => {
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) if (!isGround(pixels.slice(i, i + 3))) count++;
  return count;
};
/** Largest difference of any channel of any pixel. */
export const difference = (a: number[], b: number[]) => a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);
export const differing = (a: number[], b: number[], tolerance: number) => {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a[i + c] - b[i + c]) > tolerance)) count++;
  }
  return count;
};
