import type { CentreLine } from './centreLines.js';

/** A piece that is longer, in lengths of a stroke, is several that touch. */
const JOINED = 2;

/** How whole strokes are. Lengths are shares of that with which they were drawn. */
export interface Wholeness {
  /** The number of pieces of ink. */
  strokes: number;
  /** The length of the piece that the middle of the ink belongs to. */
  byInk: number;
  /** The same without pieces in which strokes touch, of which nobody knows how long each is. */
  apart: number;
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
  const all = inkOf(sorted);
  const single = sorted.filter(({ length }) => length <= JOINED * drawn);
  return {
    strokes: sorted.length,
    byInk: middleByInk(sorted, all) / drawn,
    apart: middleByInk(single, inkOf(single)) / drawn,
    plain: (sorted[sorted.length >> 1]?.length ?? Number.NaN) / drawn,
    joined: 1 - inkOf(single) / all,
  };
}

const inkOf = (lines: readonly CentreLine[]): number => lines.reduce((sum, { ink }) => sum + ink, 0);

/** The length of the piece that the middle of the ink belongs to. @param sorted by length */
function middleByInk(sorted: readonly CentreLine[], all: number): number {
  let left = all / 2;
  for (const { length, ink } of sorted) {
    left -= ink;
    if (left <= 0) return length;
  }
  return Number.NaN;
}
