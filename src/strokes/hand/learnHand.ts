import { checkStrokes } from './checkHand.js';
import {
  HAND_NUMBER_NAMES,
  HAND_NUMBER_RANGES,
  type Hand,
  type HandNumbers,
  type HandStroke,
  type SwatchTone,
} from './Hand.js';
import { measureSpacing, type SwatchSpacing } from './measureSpacing.js';
import { measureStroke, type StrokeMeasure } from './measureStroke.js';
import { type Polyline, polylineOf, resample, splitAtTurns } from './Polyline.js';
import { betweenDegrees, type HandLayer, separateLayers } from './separateLayers.js';

/** Options of `learnHand`. */
export interface LearnHandOptions {
  /** A name for people. */
  name?: string | undefined;
  /** How many strokes the hand keeps, 1 to 1000. Numbers are learnt from all of them. Default 120. */
  maxStrokes?: number | undefined;
  /** How many points a kept stroke has at most, 4 to 64, at steady steps. Default 24. */
  maxPoints?: number | undefined;
}

/** Swatches by their precedence for the spacing, which is defined by the middle one. */
const BY_SPACING: readonly SwatchTone[] = ['middle', 'dark', 'light'];

/** The tones from which strokes are crossed, by the lightest crossed swatch. */
const CROSSED_FROM: Readonly<Record<SwatchTone, number>> = { light: 0.125, middle: 0.375, dark: 0.625 };

/** Spacing of a lone stroke, which has no neighbours, in widths. */
const LONE_SPACING = 3;
/** Spread of the spacing of a lone stroke. */
const LONE_SPREAD = 0.3;

/** Strokes measured between two yields, in about a millisecond. */
const STROKES_PER_SLICE = 50;

/**
 * Learns a hand from strokes: measures their properties (`HandNumbers`) and keeps them, resampled to even steps of at most `maxPoints`
 * points, in thousandths of a millimetre. Strokes that turn back are split at their turns; dots are left out. A few strokes are enough:
 * numbers that they do not show, such as the spacing of a lone stroke, are set to typical values.
 *
 * @param strokes the strokes as drawn, at most 100,000 points in total
 * @throws TypeError or RangeError with the fault of the strokes or the options
 */
export function learnHand(strokes: readonly HandStroke[], options: LearnHandOptions = {}): Hand {
  const steps = learnHandSteps({ strokes, options });
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** The input of `learnHandSteps`. */
export interface LearnHandRequest {
  strokes: readonly HandStroke[];
  options?: LearnHandOptions | undefined;
}

/** Like `learnHand`, in slices of about a millisecond. Yields progress in [0, 1]. */
export function* learnHandSteps({ strokes, options = {} }: LearnHandRequest): Generator<number, Hand, void> {
  const { name, maxStrokes, maxPoints } = checkLearning(options);
  checkStrokes('learnHand', strokes);
  const measures: StrokeMeasure[] = [];
  for (const [index, stroke] of strokes.entries()) {
    for (const piece of splitAtTurns(polylineOf(stroke))) {
      measures.push(measureStroke(piece, stroke.swatch ?? 'middle'));
    }
    if (index % STROKES_PER_SLICE === STROKES_PER_SLICE - 1) yield (0.8 * index) / strokes.length;
  }
  if (measures.length === 0) throw new RangeError('learnHand: all strokes are dots; draw strokes longer than wide.');
  const layers = separateLayers(measures);
  yield 0.85;
  const numbers = { ...numbersOfStrokes(measures), ...numbersOfLayers(layers) };
  yield 0.9;
  const spacing = yield* numbersOfSpacing(layers[0], numbers.width);
  return {
    version: 1,
    ...(name !== undefined && { name }),
    strokes: kept(measures, maxStrokes).map(({ line, swatch }) => strokeOf(line, swatch, maxPoints)),
    numbers: withinRanges({ ...numbers, ...spacing }),
  };
}

/** Clamps numbers to their ranges. Unusual strokes, such as one long one among thousands of ticks, may exceed them. */
function withinRanges(numbers: HandNumbers): HandNumbers {
  const result = { ...numbers };
  for (const name of HAND_NUMBER_NAMES) {
    const { from, to } = HAND_NUMBER_RANGES[name];
    result[name] = Math.max(from, Math.min(to, numbers[name]));
  }
  return result;
}

function checkLearning({ name, maxStrokes = 120, maxPoints = 24 }: LearnHandOptions) {
  if (name !== undefined && typeof name !== 'string')
    throw new TypeError(`learnHand: name is ${String(name)}, but must be a text.`);
  checkWhole('maxStrokes', maxStrokes, 1, 1000);
  checkWhole('maxPoints', maxPoints, 4, 64);
  return { name, maxStrokes, maxPoints };
}

function checkWhole(option: string, value: number, from: number, to: number): void {
  if (!Number.isInteger(value) || value < from || value > to) {
    throw new RangeError(`learnHand: ${option} is ${String(value)}, but must be a whole number from ${from} to ${to}.`);
  }
}

const meanOf = (measures: readonly StrokeMeasure[], value: (measure: StrokeMeasure) => number): number =>
  measures.reduce((sum, measure) => sum + value(measure), 0) / measures.length;

function numbersOfStrokes(measures: readonly StrokeMeasure[]) {
  const length = meanOf(measures, (measure) => measure.length);
  const deviations = measures.reduce((sum, measure) => sum + (measure.length - length) ** 2, 0);
  const count = measures.reduce((sum, { widths }) => sum + widths[0], 0);
  const width = measures.reduce((sum, { widths }) => sum + widths[1], 0) / count;
  const squares = measures.reduce((sum, { widths }) => sum + widths[2], 0) / count;
  return {
    length,
    lengthSpread: Math.sqrt(deviations / Math.max(1, measures.length - 1)) / length,
    taperStart: meanOf(measures, ({ tapers }) => tapers.start),
    taperEnd: meanOf(measures, ({ tapers }) => tapers.end),
    width,
    widthSpread: Math.sqrt(Math.max(0, squares - width * width)) / width,
    wobble: Math.sqrt(meanOf(measures, ({ wobble }) => wobble * wobble)),
  };
}

function numbersOfLayers(layers: readonly HandLayer[]) {
  const measures = layers.flatMap(({ strokes }) => strokes);
  const curvature = layers.reduce(
    (sum, { strokes, angle }) =>
      sum +
      // Seen along the layer, a stroke that was drawn backwards bends to the other side.
      strokes.reduce((bends, stroke) => bends + stroke.curvature * Math.sign(Math.cos(stroke.angle - angle)), 0),
    0,
  );
  const [first, ...others] = layers;
  const second = others.reduce<HandLayer | undefined>(
    (most, layer) => (most && most.strokes.length >= layer.strokes.length ? most : layer),
    undefined,
  );
  const crossed = second && (['light', 'middle', 'dark'] as const).find((tone) => strokesIn(second, tone).length > 1);
  return {
    curvature: curvature / measures.length,
    angleSpread: angleSpreadOf(layers),
    crossingAngle: second ? betweenDegrees(first.angle, second.angle) : 0,
    crossingFrom: second ? CROSSED_FROM[crossed ?? 'dark'] : 1,
  };
}

const strokesIn = ({ strokes }: HandLayer, swatch: SwatchTone): StrokeMeasure[] =>
  strokes.filter((stroke) => stroke.swatch === swatch);

/** The deviation from the mean of each layer and swatch, since a sheet may be turned from swatch to swatch. */
function angleSpreadOf(layers: readonly HandLayer[]): number {
  let squares = 0;
  let free = 0;
  for (const layer of layers) {
    for (const swatch of BY_SPACING) {
      const strokes = strokesIn(layer, swatch);
      if (strokes.length < 2) continue;
      const [cosine, sine] = [0, 1].map((quarter) =>
        strokes.reduce((sum, { angle }) => sum + Math.cos(2 * angle - (quarter * Math.PI) / 2), 0),
      );
      const mean = 0.5 * Math.atan2(sine, cosine);
      squares += strokes.reduce((sum, { angle }) => sum + betweenDegrees(mean, angle) ** 2, 0);
      free += strokes.length - 1;
    }
  }
  return free > 0 ? Math.sqrt(squares / free) : 0;
}

function* numbersOfSpacing(
  layer: HandLayer,
  width: number,
): Generator<number, Pick<HandNumbers, 'spacing' | 'spacingSpread' | 'clustering' | 'overlap'>, void> {
  const swatches: SwatchSpacing[] = [];
  for (const [index, swatch] of BY_SPACING.entries()) {
    const found = measureSpacing(layer, swatch);
    if (found) swatches.push(found);
    yield 0.9 + 0.03 * (index + 1);
  }
  if (swatches.length === 0) {
    return { spacing: LONE_SPACING * width, spacingSpread: LONE_SPREAD, clustering: 0, overlap: 0 };
  }
  const pairs = swatches.reduce((sum, swatch) => sum + swatch.pairs, 0);
  const pooled = (value: (swatch: SwatchSpacing) => number): number =>
    swatches.reduce((sum, swatch) => sum + swatch.pairs * value(swatch), 0) / pairs;
  const inRows = swatches.filter(({ overlap }) => overlap !== undefined);
  const rowPairs = inRows.reduce((sum, swatch) => sum + swatch.pairs, 0);
  return {
    spacing: (swatches.find((swatch) => swatch.pairs > 1) ?? swatches[0]).spacing,
    spacingSpread: Math.sqrt(pooled(({ spread }) => spread * spread)),
    clustering: pooled(({ clustering }) => clustering),
    overlap: inRows.reduce((sum, swatch) => sum + swatch.pairs * swatch.overlap!, 0) / (rowPairs || 1),
  };
}

/** At most `most` strokes, evenly selected. */
function kept(measures: readonly StrokeMeasure[], most: number): StrokeMeasure[] {
  const count = Math.min(most, measures.length);
  return Array.from({ length: count }, (_, i) => measures[Math.floor((i * measures.length) / count)]);
}

/** The points of a stroke as plain data. */
function strokeOf(line: Polyline, swatch: SwatchTone, maxPoints: number): HandStroke {
  // Adding 0 turns −0 into 0, as JSON does.
  const thousandths = (value: number): number => Math.round(1000 * value) / 1000 + 0;
  const { x, y, width } = resample(line, line.path.length > 2 ? maxPoints : 2);
  return {
    points: Array.from(x, (value, i) => [thousandths(value), thousandths(y[i])]).flat(),
    widths: Array.from(width, (value) => Math.max(0.001, thousandths(value))),
    swatch,
  };
}
