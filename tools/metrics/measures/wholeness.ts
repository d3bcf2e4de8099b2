import type { CentreLine } from './centreLines.js';

/** How whole strokes are. Lengths are shares of that with which they were drawn. */
export interface Wholeness {
  /** The number of pieces of ink. */
  strokes: number;
  /** The length of the piece that the middle of the ink belongs to. */
  byInk: number;
  /** The length of the middle piece. */
  plain: number;
  /** The share of the ink in pieces twice as long as a stroke: strokes that touch. */
  joined: number;
}

/**
 * Compares pieces of ink with the strokes that were drawn.
 *
 * @param drawn the mean length of a stroke, in pixels
 * @param distances of each pixel to the nearest silhouette: pieces whose middle is nearer than `drawn` are left out
 * @returns NaN for lengths where nothing is left
 */
export function wholeness(
  lines: readonly CentreLine[],
  drawn: number,
  distances: ArrayLike<number> | undefined,
): Wholeness {
  const sorted = lines
    .filter(({ middle }) => distances === undefined || distances[middle] >= drawn)
    .sort((one, other) => one.length - other.length);
  const inkOf = (some: readonly CentreLine[]): number => some.reduce((sum, { ink }) => sum + ink, 0);
  const all = inkOf(sorted);
  let left = all / 2;
  const middle = sorted.find(({ ink }) => {
    left -= ink;
    return left <= 0;
  });
  return {
    strokes: sorted.length,
    byInk: (middle?.length ?? Number.NaN) / drawn,
    plain: (sorted[sorted.length >> 1]?.length ?? Number.NaN) / drawn,
    joined: inkOf(sorted.filter(({ length }) => length > 2 * drawn)) / all,
  };
}
