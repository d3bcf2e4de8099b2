import { hiddenWeight } from '../../look/hiddenOutlines.js';
import type { OutlineLook, OutlinePiece } from './OutlineMesh.js';

/** How outlines look where they are hidden: all as heavy, whatever the light and what lies behind them. */
export const hiddenLook = (look: OutlineLook): OutlineLook => ({
  ...look,
  innerContours: 1,
  shadeWeights: [1, 1],
  lostEdges: 0,
});

/** Gives pieces the weights that they have where they are hidden. */
export function weighHidden(pieces: readonly OutlinePiece[]): void {
  for (const { start, end } of pieces) {
    for (const side of [start, end])
      side.weight = side.innerWeight = hiddenWeight(Math.max(side.weight, side.innerWeight));
  }
}
