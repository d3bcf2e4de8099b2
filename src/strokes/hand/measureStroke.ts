import type { SwatchTone } from './Hand.js';
import { measureTapers, type Tapers } from './measureTapers.js';
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
