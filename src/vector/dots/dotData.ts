import type { Dot } from './placeDots.js';

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
export function ringData(ring: DotRing): string {
  const [first, ...others] = ring.map((place) => place.map((value) => Math.round(PER_MILLIMETRE * value)));
  let [left, top] = first;
  const steps: string[] = [];
  for (const [x, y] of others) {
    steps.push(written(x - left), written(y - top));
    [left, top] = [x, y];
  }
  return `M${joined(first.map(written))}l${joined(steps)}z`;
}
