import { asPhase } from '../../slices/asPhase.js';
import type { DrawingPlan } from '../DrawnScene.js';
import type { PathCounts, WrittenPath } from '../finishPaths.js';
import { asDrawn, orderPaths, travelOf } from '../order/orderPaths.js';
import type { Placement } from '../paths/pathData.js';
import type { Dot } from './placeDots.js';

/** A pen draws no dot smaller than this share of its width, and others as large as its width at least. */
const LEAST_IN_PENS = 0.7;
/** A pen draws a dot as a circle of this radius at least, so that it moves while it is down. Millimetres. */
const LEAST_CIRCLE = 0.02;

/** Orders dots and writes them as circles: path data, filled in print. Yields its progress. */
export function* finishDots(
  dots: readonly Dot[],
  { pen, order }: DrawingPlan,
  { scale, left, top }: Placement,
): Generator<number, { written: WrittenPath[]; counts: PathCounts }, void> {
  const circles = dots
    .filter(({ radius }) => pen === null || 2 * radius * scale >= LEAST_IN_PENS * pen)
    .map(({ x, y, radius }) => {
      const drawn = pen === null ? radius * scale : Math.max(radius * scale - pen / 2, LEAST_CIRCLE);
      return { x: left + scale * x, y: top + scale * y, radius: drawn };
    });
  const ends = circles.map(({ x, y }) => ({ start: [x, y] as const, end: [x, y] as const }));
  const isOrdered = order === 'travel' && pen !== null;
  const steps = isOrdered ? yield* asPhase(orderPaths(ends), 0, 1) : asDrawn(ends);
  const counts: PathCounts = {
    paths: circles.length,
    points: circles.length,
    travelBefore: travelOf(ends, asDrawn(ends)),
    travelAfter: travelOf(ends, steps),
    drawn: circles.reduce((sum, { radius }) => sum + 2 * Math.PI * radius, 0),
  };
  const written = steps.map(({ path }): WrittenPath => {
    const circle = circles[path];
    return { data: circleData(circle), length: 2 * Math.PI * circle.radius, way: [2 * circle.radius, 0] };
  });
  return { written, counts };
}

const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** A circle of two arcs. */
function circleData({ x, y, radius }: Dot): string {
  const [r, across] = [millimetres(radius), millimetres(2 * radius)];
  return `M${millimetres(x - radius)} ${millimetres(y)}a${r} ${r} 0 1 0 ${across} 0a${r} ${r} 0 1 0 -${across} 0z`;
}
