import { distance, meanWidth, type Polyline, part } from './Polyline.js';

/** The cosine of the largest angle between a stroke and its direction so far: 80 degrees. */
const TURN = 0.17;

/** The tremor of a hand, in millimetres. Shorter detours are no turns. */
const TREMOR = 0.5;

/** A piece shorter than this many widths is a dot or a hook. */
const SHORTEST = 1.5;

/**
 * Splits a stroke where it turns back, as in a scribble drawn without lifting the pen. Every piece runs forward along its chord, so that
 * its bends are distances from the chord. Dots, and hooks at the ends, are left out.
 */
export function splitAtTurns(line: Polyline): Polyline[] {
  const count = line.path.length;
  if (count < 2) return [];
  const width = meanWidth(line);
  const reach = Math.min(Math.max(1.5 * width, TREMOR), 0.25 * line.path[count - 1]);
  const pieces: Polyline[] = [];
  let start = 0;
  let farthest = 0;
  let farthestWay = 0;
  let before = 0;
  let after = 0;
  const add = (end: number): void => {
    const piece = part(line, start, end);
    const last = end - start;
    if (last > 0 && distance(piece.x[last] - piece.x[0], piece.y[last] - piece.y[0]) > SHORTEST * meanWidth(piece))
      pieces.push(piece);
  };
  for (let i = 1; i < count; i++) {
    const way = distance(line.x[i] - line.x[start], line.y[i] - line.y[start]);
    if (way > farthestWay) {
      farthestWay = way;
      farthest = i;
    }
    while (line.path[i] - line.path[before] > reach) before++;
    while (after < count - 1 && line.path[after] - line.path[i] < reach) after++;
    if (farthestWay < 2 * reach || before < start) continue;
    const dx = line.x[after] - line.x[before];
    const dy = line.y[after] - line.y[before];
    const forward = dx * (line.x[farthest] - line.x[start]) + dy * (line.y[farthest] - line.y[start]);
    if (forward >= TURN * farthestWay * distance(dx, dy)) continue;
    // The turn may lie a little ahead: go on to the point farthest away.
    while (
      farthest < count - 1 &&
      distance(line.x[farthest + 1] - line.x[start], line.y[farthest + 1] - line.y[start]) > farthestWay
    ) {
      farthest++;
      farthestWay = distance(line.x[farthest] - line.x[start], line.y[farthest] - line.y[start]);
    }
    add(farthest);
    start = farthest;
    i = farthest;
    before = farthest;
    after = farthest;
    farthestWay = 0;
  }
  add(count - 1);
  return pieces;
}
