import type { Chain } from '../Chain.js';
import type { LinePath } from '../paths/LinePath.js';
import type { EvenLine } from './evenLines.js';

/** The path of a pen along a line. pen: its width, pixels. */
export function penPath({ points }: EvenLine, pen: number): LinePath {
  const widened: number[] = [];
  for (let o = 0; o < points.length; o += 2) widened.push(points[o], points[o + 1], pen / 2, pen / 2);
  return { points: widened, isClosed: false };
}

/** A line in space, with its strokes. */
export function penChain({ points, strokes }: EvenLine, world: Float64Array, pen: number): Chain {
  const count = points.length / 2;
  return {
    ...{ count, world, screen: Float64Array.from(points), halves: new Float64Array(count).fill(pen / 2) },
    margins: strokes ? Float64Array.from(strokes.margins) : new Float64Array(count).fill(1),
    shifts: strokes && Float64Array.from(strokes.shifts),
    ...{ triangles: new Int32Array(count).fill(-1), isClosed: false, field: null, hash: 0, outline: null },
  };
}
