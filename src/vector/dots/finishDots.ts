import { asPhase } from '../../mesh/phases.js';
import type { DrawingPlan } from '../DrawnScene.js';
import type { PathCounts, WrittenPath } from '../file/finishPaths.js';
import { asDrawn, orderPaths, travelOf } from '../order/orderPaths.js';
import type { Placement } from '../paths/pathData.js';
import { discRing, penDotRing, ringData, ringLength } from './dotData.js';
import type { Dot } from './placeDots.js';

/** Smallest dot that a pen draws, as a share of its width; dots up to the width are drawn as large as that. */
const LEAST_IN_PENS = 0.7;

/** In print the dots in each square of the sheet form one path, so that they merge without a seam. Millimetres. */
const SQUARE = 10;

/** Orders dots and writes them as path data: lines of a pen, discs of a print. Yields its progress. */
export function* finishDots(
  dots: readonly Dot[],
  { pen, order }: DrawingPlan,
  { scale, left, top }: Placement,
): Generator<number, { written: WrittenPath[]; counts: PathCounts }, void> {
  const circles = dots
    .filter(({ radius }) => pen === null || 2 * radius * scale >= LEAST_IN_PENS * pen)
    .map(({ x, y, radius }) => ({ x: left + scale * x, y: top + scale * y, radius: radius * scale }));
  const ends = circles.map(({ x, y }) => ({ start: [x, y] as const, end: [x, y] as const }));
  const isOrdered = order === 'travel' && pen !== null;
  const steps = isOrdered ? yield* asPhase(orderPaths(ends), 0, 1) : asDrawn(ends);
  const rings = steps.map(({ path }) => (pen === null ? discRing(circles[path]) : penDotRing(circles[path], pen)));
  const data = rings.map(ringData);
  const written = pen === null ? joinedBySquares(circles, data) : data;
  const drawn = rings.reduce((sum, ring) => sum + ringLength(ring), 0);
  const counts: PathCounts = {
    paths: written.length,
    points: rings.reduce((sum, ring) => sum + ring.length, 0),
    travelBefore: travelOf(ends, asDrawn(ends)),
    travelAfter: travelOf(ends, steps),
    drawn,
  };
  // Dots appear one by one, each in its share of the time.
  const length = drawn / Math.max(written.length, 1);
  return { written: written.map((text) => ({ data: text, length, way: [1, 0] })), counts };
}

function joinedBySquares(circles: readonly Dot[], data: readonly string[]): string[] {
  const squares = new Map<string, string[]>();
  for (const [i, { x, y }] of circles.entries()) {
    const key = `${Math.floor(x / SQUARE)} ${Math.floor(y / SQUARE)}`;
    const square = squares.get(key);
    if (square) square.push(data[i]);
    else squares.set(key, [data[i]]);
  }
  return [...squares.values()].map((paths) => paths.join(''));
}
