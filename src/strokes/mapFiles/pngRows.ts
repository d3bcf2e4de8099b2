/** How the rows of PNG files are stored, for all that decodes them. */

/** The number of samples per pixel of each colour type: grey, RGB, palette, grey with alpha, RGB with alpha. */
export const PNG_SAMPLES: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** The number of the last of the five filters of the PNG specification. */
export const LAST_PNG_FILTER = 4;

/** Undoes a filter of a row, in place. @param pixelBytes how many bytes lie between a byte and that of the pixel on the left */
export function unfilter(line: Uint8Array, above: Uint8Array, pixelBytes: number, filter: number): void {
  if (filter === 0) return;
  for (let i = 0; i < line.length; i++) {
    const left = i >= pixelBytes ? line[i - pixelBytes] : 0;
    const up = above[i];
    if (filter === 1) line[i] += left;
    else if (filter === 2) line[i] += up;
    else if (filter === 3) line[i] += (left + up) >> 1;
    else line[i] += paeth(left, up, i >= pixelBytes ? above[i - pixelBytes] : 0);
  }
}

/** The Paeth predictor: the one of left, up and corner that is nearest to left + up − corner. */
function paeth(left: number, up: number, corner: number): number {
  const [toLeft, toUp, toCorner] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
  return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
}
