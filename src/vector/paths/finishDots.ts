import { asPhase } from '../../mesh/phases.js';
import type { Dot } from '../drawDots.js';
import type { Finish, PathCounts, WrittenPath } from './finishPaths.js';
import { asDrawn, orderPaths, travelOf } from './orderPaths.js';

/** Smallest dot that a pen draws, as a share of its width; dots up to the width are drawn as large as that. */
const LEAST_IN_PENS = 0.7;

/** In print the dots in each square of the sheet form one path, so that they merge without a seam. Millimetres. */
const SQUARE = 10;

/** Orders dots and writes them as path data: lines of a pen, discs of a print. Yields its progress. */
export function* finishDots(
  dots: readonly Dot[],
  { pen, order, placement: { scale, left, top } }: Pick<Finish, 'pen' | 'order' | 'placement'>,
): Generator<number, { written: WrittenPath[]; counts: PathCounts }, void> {
  const circles = dots
    .filter(({ radius }) => pen === null || 2 * radius * scale >= LEAST_IN_PENS * pen)
    .map(({ x, y, radius }) => ({ x: left + scale * x, y: top + scale * y, radius: radius * scale }));
  const ends = circles.map(({ x, y }) => ({ start: [x, y] as const, end: [x, y] as const }));
  const isOrdered = order === 'travel' && pen !== null;
  const steps = isOrdered ? yield* asPhase(orderPaths(ends), 0, 1) : asDrawn(ends);
  const rings = steps.map(({ path }) => (pen === null ? discRing(circles[path]) : penDotRing(circles[path], pen)));
  const written = pen === null ? joinedBySquares(circles, rings) : rings.map(penDot);
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
  return { written: written.map((path) => ({ ...path, length })), counts };
}

const penDot = (ring: DotRing): WrittenPath => ({
  ...{ data: ringData(ring), length: 0, start: ring[0], end: ring[0], way: TO_THE_RIGHT },
  line: { points: ring.flat(), isClosed: true },
});

const TO_THE_RIGHT = [1, 0] as const;

function joinedBySquares(circles: readonly Dot[], rings: readonly DotRing[]): WrittenPath[] {
  const squares = new Map<string, { start: DotRing[number]; data: string[] }>();
  for (const [i, { x, y }] of circles.entries()) {
    const key = `${Math.floor(x / SQUARE)} ${Math.floor(y / SQUARE)}`;
    const square = squares.get(key);
    if (square) square.data.push(ringData(rings[i]));
    else squares.set(key, { start: rings[i][0], data: [ringData(rings[i])] });
  }
  return [...squares.values()].map(({ start, data }) => ({
    ...{ data: data.join(''), length: 0, start, end: start, way: TO_THE_RIGHT, line: null },
  }));
}

/** Corners of a closed polyline, millimetres. */
export type DotRing = readonly (readonly [x: number, y: number])[];

/** Greatest distance between the polygon of a disc and its circle, millimetres; and the limits of its number of sides. */
const STRAY = 0.01;
const LEAST_SIDES = 8;
const MOST_SIDES = 64;

/** Positions of dots are written in thousandths of a millimetre. */
const PER_MILLIMETRE = 1000;

/** A number of thousandths, in its shortest form. */
const written = (thousandths: number): string => String(thousandths / PER_MILLIMETRE).replace(/^(-?)0\./, '$1.');

/** Numbers in a row: neither a minus sign nor a second point needs a space before it. */
const joined = (numbers: readonly string[]): string =>
  numbers.reduce((row, number, i) => {
    const isApart = number.startsWith('-') || (number.startsWith('.') && numbers[i - 1].includes('.'));
    return `${row}${isApart ? '' : ' '}${number}`;
  });

/** The number of sides of the polygon of a disc. */
const sidesOf = (radius: number): number =>
  Math.min(
    Math.max(2 * Math.ceil((0.5 * Math.PI) / Math.acos(1 - Math.min(STRAY / radius, 1))), LEAST_SIDES),
    MOST_SIDES,
  );

/**
 * A filled disc, as a polygon of its area. A circle would lose a tenth of its ink, and more the smaller it is shown: programs fill small
 * circles as inscribed polygons with eight sides or so.
 */
export function discRing({ x, y, radius }: Dot): DotRing {
  const sides = sidesOf(radius);
  const turn = (2 * Math.PI) / sides;
  const outer = radius * Math.sqrt(turn / Math.sin(turn));
  return Array.from({ length: sides }, (_, k) => [x + outer * Math.cos(turn * k), y + outer * Math.sin(turn * k)]);
}

/** Greatest distance between the turns of a spiral, in widths of the pen. */
const PITCH = 0.8;
/** Least radius of the circle that a pen draws, so that it moves while it is down. Millimetres. */
const LEAST_CIRCLE = 0.02;

/**
 * A dot of a pen: a circle around its middle or, for large dots, a spiral outwards. It is a polyline, since programs leave the middle blank
 * of a circle that is smaller than the width of its line.
 *
 * @param pen its width, millimetres
 */
export function penDotRing({ x, y, radius }: Dot, pen: number): DotRing {
  const outer = Math.max(radius - pen / 2, LEAST_CIRCLE);
  const inner = Math.min(outer, pen / 2);
  const turns = Math.ceil((outer - inner) / (PITCH * pen));
  const sides = sidesOf(outer);
  const circles = turns === 0 ? 1 : turns + 2;
  // As long as the circle that it replaces.
  const stretch = Math.PI / sides / Math.sin(Math.PI / sides);
  return Array.from({ length: sides * circles }, (_, k) => {
    const spiral = turns === 0 ? 0 : Math.min(Math.max((k / sides - 1) / turns, 0), 1);
    const [angle, reach] = [(2 * Math.PI * k) / sides, stretch * (inner + spiral * (outer - inner))];
    return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
  });
}

/** Length of a closed polyline, millimetres. */
export function ringLength(ring: DotRing): number {
  return ring.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    return sum + Math.hypot(nextX - x, nextY - y);
  }, 0);
}

/** Path data of a closed polyline. */
function ringData(ring: DotRing): string {
  const [first, ...others] = ring.map((place) => place.map((value) => Math.round(PER_MILLIMETRE * value)));
  let [left, top] = first;
  const steps: string[] = [];
  for (const [x, y] of others) {
    steps.push(written(x - left), written(y - top));
    [left, top] = [x, y];
  }
  return `M${joined(first.map(written))}l${joined(steps)}z`;
}
