import { HAND_STROKE_CONSTANTS } from './handConstants.js';

const { BUNDLED_ROWS } = HAND_STROKE_CONSTANTS;

/**
 * How far the strokes of a row are drawn aside, towards the middle row of their bundle, in mean distances between rows. Young rows lie
 * between old ones, and come and go as the distance of the viewer changes: old rows are drawn from the bundles of old rows to those of all.
 * No row is drawn farther than by `bundled`.
 *
 * @param halves twice the number of an old row, or the odd number of a young one between two
 * @param young the share of the young rows that are there
 * @param bundled the share of their distance by which rows are drawn together
 */
export function drawnAside(halves: number, young: number, bundled: number): number {
  const apart = 1 + young;
  const ofAll = 0.5 * fromMiddle(halves);
  return -bundled * apart * (halves % 2 === 0 ? ofAll * young + (1 - young) * fromMiddle(halves / 2) : ofAll);
}

/** The number of a row within its bundle, 0 for the middle one. */
const fromMiddle = (row: number): number => {
  const half = BUNDLED_ROWS / 2;
  return ((((row + half) % BUNDLED_ROWS) + BUNDLED_ROWS) % BUNDLED_ROWS) - half;
};

/** The deviation of the distances of rows in bundles, as a share of their mean. */
export const spreadOfBundles = (bundled: number): number => bundled * Math.sqrt(BUNDLED_ROWS - 1);
