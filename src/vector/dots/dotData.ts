import type { Dot } from './placeDots.js';

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
export const sidesOf = (radius: number): number =>
  Math.min(
    Math.max(2 * Math.ceil((0.5 * Math.PI) / Math.acos(1 - Math.min(STRAY / radius, 1))), LEAST_SIDES),
    MOST_SIDES,
  );

/**
 * A filled disc, as a polygon of its area. Programs fill small circles as polygons within them, of eight sides or so: a tenth of the ink
 * would be lost, and more the smaller they are shown.
 */
export function discData({ x, y, radius }: Dot): string {
  const sides = sidesOf(radius);
  const turn = (2 * Math.PI) / sides;
  const outer = radius * Math.sqrt(turn / Math.sin(turn));
  const at = (k: number): readonly [number, number] => [
    Math.round(PER_MILLIMETRE * (x + outer * Math.cos(turn * k))),
    Math.round(PER_MILLIMETRE * (y + outer * Math.sin(turn * k))),
  ];
  let [left, top] = at(0);
  const first = joined([written(left), written(top)]);
  const steps: string[] = [];
  for (let k = 1; k < sides; k++) {
    const [nextLeft, nextTop] = at(k);
    steps.push(written(nextLeft - left), written(nextTop - top));
    [left, top] = [nextLeft, nextTop];
  }
  return `M${first}l${joined(steps)}z`;
}

const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** A circle that a pen draws, of two arcs. */
export function circleData({ x, y, radius }: Dot): string {
  const [r, across] = [millimetres(radius), millimetres(2 * radius)];
  return `M${millimetres(x - radius)} ${millimetres(y)}a${r} ${r} 0 1 0 ${across} 0a${r} ${r} 0 1 0 -${across} 0z`;
}
