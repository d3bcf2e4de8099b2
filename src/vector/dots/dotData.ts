import type { Dot } from './placeDots.js';

/** Corners of a closed line, millimetres. */
export type DotRing = readonly (readonly [x: number, y: number])[];

/** The sides of a disc lie within its circle by no more than this, millimetres, and they are so many. */
const STRAY = 0.01;
const LEAST_SIDES = 8;
const MOST_SIDES = 64;

/** Files have numbers of thousandths of a millimetre where dots lie. */
const PER_MILLIMETRE = 1000;

/** A number of thousandths, as short as it gets. */
const written = (thousandths: number): string => String(thousandths / PER_MILLIMETRE).replace(/^(-?)0\./, '$1.');

/** Numbers in a row: neither a minus sign nor a second point needs a space before it. */
const joined = (numbers: readonly string[]): string =>
  numbers.reduce((row, number, i) => {
    const isApart = number.startsWith('-') || (number.startsWith('.') && numbers[i - 1].includes('.'));
    return `${row}${isApart ? '' : ' '}${number}`;
  });

/** How many sides the outline of a disc has. */
const sidesOf = (radius: number): number =>
  Math.min(
    Math.max(2 * Math.ceil((0.5 * Math.PI) / Math.acos(1 - Math.min(STRAY / radius, 1))), LEAST_SIDES),
    MOST_SIDES,
  );

/**
 * A filled disc, as a polygon of its area. Programs fill small circles as polygons within them, of eight sides or so: a tenth of the ink
 * would be lost, and more the smaller they are shown.
 */
export function discRing({ x, y, radius }: Dot): DotRing {
  const sides = sidesOf(radius);
  const turn = (2 * Math.PI) / sides;
  const outer = radius * Math.sqrt(turn / Math.sin(turn));
  return Array.from({ length: sides }, (_, k) => [x + outer * Math.cos(turn * k), y + outer * Math.sin(turn * k)]);
}

/** Turns of a spiral lie apart by no more than so much of the pen's width. */
const PITCH = 0.8;
/** A pen goes around the middle of a dot by this radius at least, so that it moves while it is down. Millimetres. */
const LEAST_CIRCLE = 0.02;

/**
 * A dot that a pen draws: around its middle, and if that leaves it blank, from a smaller circle outwards in a spiral. It is made of straight
 * pieces: programs leave the middle of a circle blank that is smaller than the width of its line.
 *
 * @param pen its width, millimetres
 */
export function penDotRing({ x, y, radius }: Dot, pen: number): DotRing {
  const outer = Math.max(radius - pen / 2, LEAST_CIRCLE);
  const inner = Math.min(outer, pen / 2);
  const turns = Math.ceil((outer - inner) / (PITCH * pen));
  const sides = sidesOf(outer);
  const circles = turns === 0 ? 1 : turns + 2;
  // As long as the circle that it stands for.
  const stretch = Math.PI / sides / Math.sin(Math.PI / sides);
  return Array.from({ length: sides * circles }, (_, k) => {
    const spiral = turns === 0 ? 0 : Math.min(Math.max((k / sides - 1) / turns, 0), 1);
    const [angle, reach] = [(2 * Math.PI * k) / sides, stretch * (inner + spiral * (outer - inner))];
    return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
  });
}

/** How long a closed line is, millimetres. */
export function ringLength(ring: DotRing): number {
  return ring.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    return sum + Math.hypot(nextX - x, nextY - y);
  }, 0);
}

/** The path data of a closed line. */
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
