/** Pixels that a card shades as one group, by width and height. */
export type BlockSize = readonly [width: number, height: number];

/**
 * How often a group of pixels runs a branch, on average over the groups that show something: as often as the pixel of it that runs it most
 * often, since a card runs a branch for all of a group.
 *
 * @param runs how often each pixel has run the branch, row by row
 * @param shown for each pixel, whether it shows anything; others count for nothing
 */
export function blockMean(
  runs: ArrayLike<number>,
  shown: ArrayLike<number>,
  side: number,
  [width, height]: BlockSize,
): number {
  let blocks = 0;
  let sum = 0;
  for (let top = 0; top < side; top += height) {
    for (let left = 0; left < side; left += width) {
      let most = -1;
      for (let y = top; y < Math.min(top + height, side); y++)
        for (let x = left; x < Math.min(left + width, side); x++)
          if (shown[y * side + x]) most = Math.max(most, runs[y * side + x]);
      if (most < 0) continue;
      blocks++;
      sum += most;
    }
  }
  return blocks === 0 ? 0 : sum / blocks;
}
