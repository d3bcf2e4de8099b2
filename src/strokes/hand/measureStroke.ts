import type { SwatchTone } from './Hand.js';
import { distance, type Polyline, resample } from './Polyline.js';

/** The number of points at which a stroke is sampled. */
const SAMPLES = 65;

/** The mean of the squares of −1 to 1 at the samples, which makes the parabola of an arc independent of its straight part. */
const MEAN_SQUARE = (SAMPLES + 1) / (3 * (SAMPLES - 1));

/** The measures of one stroke. Lengths are in millimetres; its smooth arc is middle + forward·s + bend·(s² − m), s from −1 to 1. */
export interface StrokeMeasure {
  line: Polyline;
  swatch: SwatchTone;
  /** The direction of the chord as it was drawn, in radians, clockwise from x. */
  angle: number;
  /** The length of the smooth arc. */
  length: number;
  middle: readonly [x: number, y: number];
  forward: readonly [x: number, y: number];
  bend: readonly [x: number, y: number];
  /** The height of the arc over its chord, as a share of the chord; positive to the right-hand side. */
  curvature: number;
  /** Root mean square distance from the smooth arc. */
  wobble: number;
  tapers: Tapers;
  /** Number, sum and sum of squares of the widths without the tapers. */
  widths: readonly [count: number, sum: number, squares: number];
}

function placeOf(sample: number): number {
  return (2 * sample) / (SAMPLES - 1) - 1;
}

/** A coordinate of the smooth arc at s from −1 to 1. */
export const arcAt = ({ middle, forward, bend }: StrokeMeasure, axis: 0 | 1, s: number): number =>
  middle[axis] + forward[axis] * s + bend[axis] * (s * s - MEAN_SQUARE);

/** Measures one stroke, which goes forward along its chord. */
export function measureStroke(line: Polyline, swatch: SwatchTone): StrokeMeasure {
  const samples = resample(line, SAMPLES);
  const [x, y] = [fitArc(samples.x), fitArc(samples.y)];
  const forward = [x.forward, y.forward] as const;
  const bend = [x.bend, y.bend] as const;
  const half = distance(forward[0], forward[1]);
  const [cosine, sine] = [forward[0] / half, forward[1] / half];
  const tapers = measureTapers(samples.width);
  const measure = {
    line,
    swatch,
    angle: Math.atan2(forward[1], forward[0]),
    length: lengthOfArc(forward, bend),
    middle: [x.middle, y.middle] as const,
    forward,
    bend,
    // In the middle the arc lies −bend off the chord. The right-hand side of (cosine, sine) is (−sine, cosine), since y goes down.
    curvature: (sine * bend[0] - cosine * bend[1]) / (2 * half),
    tapers,
    widths: fullWidths(samples.width, tapers),
    wobble: 0,
  };
  let squares = 0;
  for (let i = 0; i < SAMPLES; i++) {
    const s = placeOf(i);
    // Across the arc at this place, not across the chord.
    const [dx, dy] = [forward[0] + 2 * bend[0] * s, forward[1] + 2 * bend[1] * s];
    const [offX, offY] = [samples.x[i] - arcAt(measure, 0, s), samples.y[i] - arcAt(measure, 1, s)];
    squares += (dx * offY - dy * offX) ** 2 / (dx * dx + dy * dy || 1);
  }
  measure.wobble = Math.sqrt(squares / SAMPLES);
  return measure;
}

/** Fits a parabola to a coordinate by least squares. */
function fitArc(values: Float64Array): { middle: number; forward: number; bend: number } {
  let sum = 0;
  let forward = 0;
  let bend = 0;
  let bendSquares = 0;
  for (let i = 0; i < SAMPLES; i++) {
    const s = placeOf(i);
    const square = s * s - MEAN_SQUARE;
    sum += values[i];
    forward += values[i] * s;
    bend += values[i] * square;
    bendSquares += square * square;
  }
  return { middle: sum / SAMPLES, forward: forward / (SAMPLES * MEAN_SQUARE), bend: bend / bendSquares };
}

function lengthOfArc(forward: readonly [number, number], bend: readonly [number, number]): number {
  const steps = 16;
  let length = 0;
  for (let i = 0; i < steps; i++) {
    const s = (2 * i + 1) / steps - 1;
    length += (2 / steps) * distance(forward[0] + 2 * bend[0] * s, forward[1] + 2 * bend[1] * s);
  }
  return length;
}

function fullWidths(width: Float64Array, { start, end, full }: Tapers): [number, number, number] {
  let [count, sum, squares] = [0, 0, 0];
  const last = width.length - 1;
  for (let i = Math.ceil(start * last); i <= Math.floor((1 - end) * last); i++) {
    count++;
    sum += width[i];
    squares += width[i] ** 2;
  }
  return count > 0 ? [count, sum, squares] : [1, full, full * full];
}

/** Lengths are tried in steps of 1/STEPS of the stroke. */
const STEPS = 64;
/** The first search uses every COARSE-th step. */
const COARSE = 4;

/** An end counts as tapered if its tip is thinner than the stroke by more than this share of the full width. */
const LEAST_DROP = 0.15;

/** The tapers of one stroke. */
interface Tapers {
  /** The length over which it grows from its start, as a share of its length. */
  start: number;
  /** The length over which it narrows towards its end. */
  end: number;
  /** Its full width. */
  full: number;
}

/**
 * Fits a width that grows linearly, stays, and shrinks linearly, by least squares over the lengths of the two ends.
 *
 * @param width the widths at even steps from start to end
 */
function measureTapers(width: Float64Array): Tapers {
  const fit = bestFit(width);
  const { full } = fit;
  return {
    start: fit.startDrop > LEAST_DROP * full ? fit.start / STEPS : 0,
    end: fit.endDrop > LEAST_DROP * full ? fit.end / STEPS : 0,
    full,
  };
}

interface Fit {
  /** Lengths of the ends, in steps. */
  start: number;
  end: number;
  full: number;
  /** How much thinner the tips are. */
  startDrop: number;
  endDrop: number;
  /** The sum of squares that the fit explains. */
  explained: number;
}

function bestFit(width: Float64Array): Fit {
  const products: Products = { start: [], end: [] };
  const sum = width.reduce((total, value) => total + value, 0);
  let best = fitTo(width, sum, 0, 0, products);
  const tryAll = (starts: readonly number[], ends: readonly number[]): void => {
    for (const start of starts) {
      for (const end of ends) {
        if (start < 0 || end < 0 || start + end > STEPS) continue;
        const fit = fitTo(width, sum, start, end, products);
        if (fit.explained > best.explained) best = fit;
      }
    }
  };
  const coarse = Array.from({ length: STEPS / COARSE + 1 }, (_, i) => COARSE * i);
  tryAll(coarse, coarse);
  const near = (step: number): number[] => Array.from({ length: 2 * COARSE - 1 }, (_, i) => step + i - COARSE + 1);
  tryAll(near(best.start), near(best.end));
  return best;
}

/** How far a place is within a tapered end of `steps` steps: 1 at the tip, 0 from its full width on. */
const inside = (place: number, steps: number): number => (steps > 0 ? Math.max(0, 1 - (place * STEPS) / steps) : 0);

/** The sums of widths times `inside` of their places within ends of so many steps, as far as they are known. */
interface Products {
  start: (number | undefined)[];
  end: (number | undefined)[];
}

const LAST = SAMPLES - 1;

/** The samples within an end of `steps` steps. */
const samplesWithin = (steps: number): number => Math.ceil((steps * LAST) / STEPS);

function productAtStart(width: Float64Array, steps: number): number {
  let total = 0;
  for (let i = 0; i < samplesWithin(steps); i++) total += width[i] * inside(i / LAST, steps);
  return total;
}

function productAtEnd(width: Float64Array, steps: number): number {
  let total = 0;
  for (let i = SAMPLES - samplesWithin(steps); i < SAMPLES; i++) total += width[i] * inside(1 - i / LAST, steps);
  return total;
}

/** The sums of `inside` and of its square over all samples, for each number of steps. */
const MOMENTS = /* @__PURE__ */ Array.from({ length: STEPS + 1 }, (_, steps) => momentsOf(steps));

function momentsOf(steps: number): readonly [sum: number, squares: number] {
  let sum = 0;
  let squares = 0;
  for (let i = 0; i < samplesWithin(steps); i++) {
    const value = inside(i / LAST, steps);
    sum += value;
    squares += value * value;
  }
  return [sum, squares];
}

/** The least squares of width = full − startDrop·inside(x) − endDrop·inside(1 − x). */
function fitTo(width: Float64Array, sum: number, start: number, end: number, products: Products): Fit {
  // The two ends do not overlap, so their products with each other are 0.
  products.start[start] ??= productAtStart(width, start);
  products.end[end] ??= productAtEnd(width, end);
  const [fromStart, fromEnd] = [products.start[start], products.end[end]];
  const [sumStart, squareStart] = MOMENTS[start];
  const [sumEnd, squareEnd] = MOMENTS[end];
  // The drops are eliminated from the normal equations, which leaves one equation for the full width.
  const shareStart = squareStart > 0 ? sumStart / squareStart : 0;
  const shareEnd = squareEnd > 0 ? sumEnd / squareEnd : 0;
  const full =
    (sum - shareStart * fromStart - shareEnd * fromEnd) / (SAMPLES - shareStart * sumStart - shareEnd * sumEnd);
  const startDrop = squareStart > 0 ? (full * sumStart - fromStart) / squareStart : 0;
  const endDrop = squareEnd > 0 ? (full * sumEnd - fromEnd) / squareEnd : 0;
  // Ends that become wider are no tapers.
  if (startDrop < 0 || endDrop < 0 || !Number.isFinite(full)) {
    return { start: 0, end: 0, full: sum / SAMPLES, startDrop: 0, endDrop: 0, explained: Number.NEGATIVE_INFINITY };
  }
  return { start, end, full, startDrop, endDrop, explained: full * sum - startDrop * fromStart - endDrop * fromEnd };
}
