import { hiddenWeight } from '../../look/hiddenOutlines.js';
import type { OutlineLook, OutlinePiece } from './OutlineMesh.js';

/** The look of hidden outlines: all of one weight, whatever the light and what lies behind them. */
export const hiddenLook = (look: OutlineLook): OutlineLook => ({
  ...look,
  innerContours: 1,
  shadeWeights: [1, 1],
  lostEdges: 0,
});

/** Sets the weights of pieces to those of hidden outlines. */
export function weighHidden(pieces: readonly OutlinePiece[]): void {
  for (const { start, end } of pieces) {
    for (const side of [start, end])
      side.weight = side.innerWeight = hiddenWeight(Math.max(side.weight, side.innerWeight));
  }
}
