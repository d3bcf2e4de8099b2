import type { SurfaceImage } from './SurfaceImage.js';

/** How far blocks of a picture are from their tone. */
export interface BlockTones {
  /** The number of blocks. */
  blocks: number;
  /** The mean of their differences without sign: how uneven the strokes lie, and how wrong the tone is. */
  error: number;
  /** The mean of their differences: how wrong the tone is. */
  bias: number;
}

/** Compares the ink in each block that shows the surface alone with the tone that it should have. @param side of a block, in pixels */
export function blockTones({ width, height, luminance, surface }: SurfaceImage, tone: number, side = 32): BlockTones {
  let [blocks, error, bias] = [0, 0, 0];
  for (let top = 0; top + side <= height; top += side) {
    for (let left = 0; left + side <= width; left += side) {
      let ink = 0;
      let shown = 0;
      for (let y = top; y < top + side; y++) {
        for (let i = y * width + left; i < y * width + left + side; i++) {
          if (surface[i] === 0) continue;
          shown++;
          ink += 1 - luminance[i];
        }
      }
      if (shown < side * side) continue;
      const off = ink / shown - tone;
      blocks++;
      error += Math.abs(off);
      bias += off;
    }
  }
  return { blocks, error: error / blocks, bias: bias / blocks };
}
