import type { TracedStroke } from './measureChain.js';

/** Bins of the angles of strokes, from 0 to 180 degrees. */
const BINS = 36;

/**
 * Gives strokes a likely direction of drawing, in place. Ink does not show it, but the strokes of a layer are drawn one way: the direction
 * reverses at the angle that the fewest strokes have, and most strokes go to the right.
 */
export function directStrokes(strokes: readonly TracedStroke[]): void {
  const chords = strokes.map(({ xs, ys }) => ({ x: xs[xs.length - 1] - xs[0], y: ys[ys.length - 1] - ys[0] }));
  const cut = emptiestAngle(chords);
  const turned = chords.map(({ x, y }) => Math.sin(Math.atan2(y, x) - cut) < 0);
  let right = 0;
  chords.forEach(({ x }, i) => {
    right += turned[i] ? -x : x;
  });
  strokes.forEach(({ xs, ys, widths }, i) => {
    if (turned[i] === right >= 0) for (const values of [xs, ys, widths]) values.reverse();
  });
}

function emptiestAngle(chords: readonly { x: number; y: number }[]): number {
  const lengths = new Float64Array(BINS);
  for (const { x, y } of chords) {
    const turn = (((Math.atan2(y, x) / Math.PI) % 1) + 1) % 1;
    lengths[Math.min(BINS - 1, Math.floor(turn * BINS))] += Math.hypot(x, y);
  }
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  for (let bin = 0; bin < BINS; bin++) {
    let sum = 0;
    // Bins nearby count too, so that the middle of the widest gap is found.
    for (let away = -8; away <= 8; away++) {
      sum += lengths[(bin + away + BINS) % BINS] / (1 + away * away);
    }
    if (sum >= least) continue;
    least = sum;
    best = bin;
  }
  return ((best + 0.5) * Math.PI) / BINS;
}
