import { lightness } from '../../look/vectors.js';
import type { ValueCurve } from './ToneFit.js';
import type { Color } from './WeightedColors.js';

const clamp01 = (value: number): number => Math.min(Math.max(value, 0), 1);

/** A lightness of the scene with its share of the surface, and the darkness that is planned for it. */
interface Value {
  lightness: number;
  weight: number;
  /** The share of what is lighter. */
  before: number;
  darkness: number;
}

/** The share of the surface, the lightest colours, that is left to the paper, and the darkness of the darkest colour. */
const PAPER = 0.55;
const DARKEST = 0.7;
/** The share of the surface from which on the lightest colours alone make the lights of a picture. */
const LIGHTS = 0.2;
/** How much of a value's own surface counts in its rank. */
const OWN = 0.25;
/** The step by which neighbouring values differ, and the steepest rise of the darkness that may be needed for it. */
const STEP = 0.15;
const STEEPEST = 1.5;
/** Nearly black things are never quite white: the lightness at which they begin, and the darkness of black. */
const NEARLY_BLACK = 0.3;
const LEAST_BLACK = 0.3;
/** Lightnesses that are nearer than this are one value. */
const ONE_VALUE = 0.05;
/** The share of the surface from which on a value is a mass, with a step of its own, and below which it is a spot. */
const MASS = 0.1;
export const SPOT = 0.02;

/**
 * Plans the values of a scene: which colours are left to the paper, which are half tones and which are dark. The darkness of a colour
 * follows from its rank, light before dark, by the surface that has it; so the picture has its lights, whether the scene is light or dark
 * all over. Neighbouring values differ by a step, as far as their lightness does; those that are left to the paper by one step together.
 * Where colours differ in hue alone, red, green and blue count as behind a filter before the lens, so that they become different greys.
 */
export function planValues(colors: readonly Color[]): ValueCurve {
  const filter = filterFor(colors);
  const values = valuesOf(colors, filter);
  if (values.length === 0) values.push({ lightness: 1, weight: 1, before: 0, darkness: 0 });
  rank(values);
  separate(values);
  return { filter, ...curveThrough(values) };
}

/** The values of colours behind a filter, from light to dark. */
function valuesOf(colors: readonly Color[], filter: ValueCurve['filter']): Value[] {
  const seen = colors
    .map((color) => ({ lightness: behind(filter, color), weight: color.weight, before: 0, darkness: 0 }))
    .sort((a, b) => b.lightness - a.lightness);
  const values: Value[] = [];
  let [lightest, before] = [0, 0];
  for (const one of seen) {
    const last = values.at(-1);
    if (last && lightest - one.lightness < ONE_VALUE) {
      const weight = last.weight + one.weight;
      last.lightness += ((one.lightness - last.lightness) * one.weight) / weight;
      last.weight = weight;
    } else {
      lightest = one.lightness;
      values.push({ ...one, before });
    }
    before += one.weight;
  }
  return values;
}

/** Sets the darkness of values by their rank. */
function rank(values: readonly Value[]): void {
  const white = lightestOf(values);
  for (const value of values) {
    const share = value.before + OWN * value.weight;
    const ranked = DARKEST * clamp01((share - PAPER) / (1 - PAPER));
    // A faint difference does not become a coarse one.
    value.darkness = Math.min(ranked, STEEPEST * Math.max(white - value.lightness, 0));
    value.darkness = Math.max(value.darkness, LEAST_BLACK * clamp01(1 - value.lightness / NEARLY_BLACK));
  }
}

/** The lightness of the lightest value that is more than a spot. */
const lightestOf = (values: readonly Value[]): number =>
  (values.find(({ weight }) => weight >= SPOT) ?? values[0]).lightness;

/** Makes neighbouring masses differ by a step; of many, by a lesser one, so that light ones stay nearly blank. */
function separate(values: readonly Value[]): void {
  const masses = values.filter(({ weight }) => weight >= MASS);
  const even = DARKEST / Math.max(masses.length - 1, 1);
  const step = even >= STEP ? STEP : even / 2;
  const onPaper = masses.filter(({ before }) => before < PAPER).length;
  for (let i = 1; i < masses.length; i++) {
    const [lighter, value] = [masses[i - 1], masses[i]];
    // What is lighter leaves too little paper if it is a small share of the whole.
    const most = i < onPaper ? (STEP * Math.min(1, value.before / LIGHTS)) / (onPaper - 1) : step;
    const wanted = Math.min(step, most, STEEPEST * (lighter.lightness - value.lightness));
    value.darkness = Math.max(value.darkness, lighter.darkness + wanted);
  }
  const most = masses.at(-1)?.darkness ?? 0;
  if (most > DARKEST) for (const value of values) value.darkness *= DARKEST / most;
  // A spot is not lighter than what is lighter in the scene.
  for (let i = 1; i < values.length; i++) values[i].darkness = Math.max(values[i].darkness, values[i - 1].darkness);
}

/** The number of places at which the slope of the curve changes. */
const KNOTS = 4;

/** The curve from lightness to darkness, straight between a few values, and level before the first. A darker colour that comes later is darker than the last. */
function curveThrough(values: readonly Value[]): Pick<ValueCurve, 'knots' | 'bends'> {
  const points = values.filter(({ darkness }, i) => darkness > 0 || !(values[i + 1]?.darkness === 0));
  const [first] = points;
  if (first.darkness > 0)
    points.unshift({
      lightness: Math.min(1, first.lightness + first.darkness / STEEPEST) + ONE_VALUE,
      weight: 0,
      before: 0,
      darkness: 0,
    });
  const last = points[points.length - 1];
  const ofBlack = Math.min(DARKEST, last.darkness + STEEPEST * last.lightness);
  if (ofBlack > last.darkness + ONE_VALUE) points.push({ lightness: 0, weight: 0, before: 1, darkness: ofBlack });
  while (points.length > KNOTS) points.splice(leastMissed(points), 1);
  const knots = points.map(({ lightness }) => lightness);
  const slopes = points.map((point, i) => {
    const next = points[i + 1];
    return next ? (next.darkness - point.darkness) / (point.lightness - next.lightness) : 0;
  });
  const bends = slopes.map((slope, i) => slope - (slopes[i - 1] ?? 0));
  const none = Array<number>(KNOTS - points.length).fill(0);
  return { knots: [...knots, ...none] as Four, bends: [...bends, ...none] as Four };
}

type Four = [number, number, number, number];

/** The index of the point between the ends without which the curve changes least. */
function leastMissed(points: readonly Value[]): number {
  let [found, least] = [1, Infinity];
  for (let i = 1; i + 1 < points.length; i++) {
    const [a, b, c] = [points[i - 1], points[i], points[i + 1]];
    const along = (a.lightness - b.lightness) / (a.lightness - c.lightness);
    const missed = Math.abs(a.darkness + along * (c.darkness - a.darkness) - b.darkness) * (b.weight + SPOT);
    if (missed < least) [found, least] = [i, missed];
  }
  return found;
}

/** The weights of red, green and blue in the luminance, and those behind a red, orange, green, cyan, magenta, purple and blue filter. */
const FILTERS: readonly ValueCurve['filter'][] = [
  [0.2126, 0.7152, 0.0722],
  [0.7, 0.25, 0.05],
  [0.45, 0.5, 0.05],
  [0.1, 0.85, 0.05],
  [0.05, 0.55, 0.4],
  [0.5, 0.1, 0.4],
  [0.85, 0, 0.15],
  [0.1, 0.3, 0.6],
];
/** The share of the surface that may be lost beside what it differs from in hue, before a filter is taken. */
const LOST = 0.02;
/** The least difference in red, green or blue, as lightness, by which colours differ to the eye. */
const DIFFERENT = 0.2;

/** The filter behind which few colours look alike that do not, and most of the surface is as light as the lightest. */
function filterFor(colors: readonly Color[]): ValueCurve['filter'] {
  const main = colors.filter(({ weight }) => weight >= SPOT);
  const [plain] = FILTERS;
  if (lostBehind(plain, main) <= LOST) return plain;
  const missed = FILTERS.map((filter) => lostBehind(filter, main) + darkBehind(filter, main));
  return FILTERS[missed.indexOf(Math.min(...missed))];
}

/** How much darker than the lightest of them colours are on the whole. */
function darkBehind(filter: ValueCurve['filter'], colors: readonly Color[]): number {
  const seen = colors.map((color) => behind(filter, color));
  const lightest = Math.max(...seen);
  return colors.reduce((sum, { weight }, i) => sum + weight * (lightest - seen[i]), 0);
}

/** The share of the surface whose neighbours in lightness are of another colour. */
function lostBehind(filter: ValueCurve['filter'], colors: readonly Color[]): number {
  const seen = colors.map((color) => behind(filter, color));
  let lost = 0;
  for (let i = 0; i < colors.length; i++)
    for (let j = 0; j < i; j++) {
      if (!differ(colors[i], colors[j])) continue;
      lost += Math.min(colors[i].weight, colors[j].weight) * clamp01(1 - Math.abs(seen[i] - seen[j]) / STEP);
    }
  return lost;
}

const differ = (a: Color, b: Color): boolean =>
  (['r', 'g', 'b'] as const).some((one) => Math.abs(lightness(a[one]) - lightness(b[one])) > DIFFERENT);

/** The lightness of a colour behind a filter. */
export const behind = ([r, g, b]: ValueCurve['filter'], color: Omit<Color, 'weight'>): number =>
  lightness(clamp01(r * color.r + g * color.g + b * color.b));

/** The darkness that a curve has for a lightness. */
export const darknessOf = ({ knots, bends }: ValueCurve, light: number): number =>
  knots.reduce((sum, knot, i) => sum + bends[i] * Math.max(knot - light, 0), 0);
