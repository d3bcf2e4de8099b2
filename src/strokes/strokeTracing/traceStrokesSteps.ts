import { asPhase, chunkPhase } from '../../mesh/phases.js';
import type { HandStroke, SwatchTone } from '../hand/Hand.js';
import { depthOfLines, findInk, type Ink } from './findInk.js';
import { measureChain, resample, type TracedStroke } from './measureChain.js';
import { findPaper } from './PaperGrid.js';
import { resolveJunctions } from './resolveJunctions.js';
import { checkScannedImage, readGrey, reductionOf, type ScannedImage } from './ScannedImage.js';
import { type SkeletonGraph, traceGraph } from './SkeletonGraph.js';
import { measureDistances, thin } from './thin.js';

/** Assumed width of a swatch on paper, in millimetres. */
const SWATCH_MILLIMETRES = 60;
/** Largest number of strokes of a swatch. */
const MOST_STROKES = 1000;
/** A picture with more branches is a texture. */
const MOST_BRANCHES = 40_000;
/** Largest number of points of a stroke. */
const MOST_POINTS = 96;
/** Ink wider than this share of the smaller side of the picture is no stroke. */
const WIDEST_SHARE = 0.15;
/** The width in pixels given to points without width. */
const LEAST_WIDTH = 0.05;
/** Strokes between two yields. */
const STROKES_PER_SLICE = 4;

/** Facts about a picture of strokes. */
export interface TraceOptions {
  /** The size of a pixel on the paper. Default: the picture is 60 mm wide. */
  millimetresPerPixel?: number | undefined;
  /** The intended darkness of the swatch. Default: unknown. */
  swatch?: SwatchTone | undefined;
}

/** A picture and facts about it. */
export interface TraceRequest extends TraceOptions {
  image: ScannedImage;
}

/**
 * Finds the strokes in a photograph or a scan of a swatch: separates ink from paper in uneven light, thins it to lines, lets lines that cross
 * go straight on, and measures the width along each.
 *
 * A stroke's ends are where a round pen would have stood: a blunt end lies half a width before the end of its ink, a pointed one at its
 * point. Strokes should be three pixels wide or more, and apart from each other by as much; those that touch side by side become one.
 *
 * @throws TypeError or RangeError at the first step if the picture or an option is out of its range; Error if there are no strokes
 * @returns the strokes, in millimetres from the picture's upper left corner; yields progress in [0, 1]
 */
export function* traceStrokesSteps({
  image,
  millimetresPerPixel,
  swatch,
}: TraceRequest): Generator<number, HandStroke[], void> {
  checkScannedImage(image);
  checkOptions(millimetresPerPixel, swatch);
  const grey = yield* asPhase(readGrey(image), 0, 0.1);
  const { width, height } = grey;
  const paper = yield* asPhase(findPaper(grey), 0.1, 0.15);
  if (!paper) throw noStrokes('it is the same all over');
  const ink = yield* asPhase(findInk(grey, paper), 0.15, 0.4);
  const distances = yield* asPhase(measureDistances(ink.mask, width, height), 0.4, 0.55);
  let widest = 0;
  yield* chunkPhase(distances.length, 0.55, 0.57, (start, end) => {
    widest = Math.max(widest, greatest(distances, start, end));
  });
  const isBlot = 0.5 * WIDEST_SHARE * Math.min(width, height);
  if (widest > isBlot) dropBlots(ink.mask, distances, width, isBlot);
  const skeleton = ink.mask.slice();
  const pixels = yield* asPhase(thin(skeleton, width, Math.min(widest, isBlot)), 0.57, 0.75);
  const graph = yield* asPhase(traceGraph(skeleton, pixels, distances, width), 0.75, 0.8);
  const fullDepth = depthOfLines(ink, pixels, distances);
  const traced = yield* asPhase(measureAll({ ...ink, fullDepth }, graph), 0.8, 0.99);
  directStrokes(traced);
  const scale = (millimetresPerPixel ?? SWATCH_MILLIMETRES / image.width) * reductionOf(image);
  return traced.map((stroke) => handStroke(stroke, scale, swatch));
}

const noStrokes = (why: string): Error => new Error(`traceStrokes: no strokes were found in the picture: ${why}.`);

function checkOptions(millimetresPerPixel: number | undefined, swatch: SwatchTone | undefined): void {
  if (millimetresPerPixel !== undefined && !(millimetresPerPixel > 0 && millimetresPerPixel < Infinity)) {
    throw new RangeError(
      `traceStrokes: millimetresPerPixel is ${String(millimetresPerPixel)}, but must be a number above 0, or left out.`,
    );
  }
  if (swatch !== undefined && !['light', 'middle', 'dark'].includes(swatch)) {
    throw new RangeError(`traceStrokes: swatch is ${String(swatch)}, but must be light, middle or dark, or left out.`);
  }
}

function greatest(values: Float32Array, start: number, end: number): number {
  let result = 0;
  for (let i = start; i < end; i++) if (values[i] > result) result = values[i];
  return result;
}

function* measureAll(ink: Ink, graph: SkeletonGraph): Generator<number, TracedStroke[], void> {
  if (graph.branches.length > MOST_BRANCHES) throw tooMany(graph.branches.length);
  const chains = resolveJunctions(graph);
  yield 0.1;
  const strokes: TracedStroke[] = [];
  for (const [i, chain] of chains.entries()) {
    const stroke = measureChain(ink, chain);
    if (stroke) strokes.push(stroke);
    if (i % STROKES_PER_SLICE === 0) yield 0.1 + (0.9 * i) / chains.length;
  }
  const kept = withoutDust(strokes);
  if (kept.length === 0)
    throw noStrokes(chains.length > 0 ? 'what is dark in it is no longer than wide' : 'it has no lines');
  if (kept.length > MOST_STROKES) throw tooMany(kept.length);
  return kept;
}

const tooMany = (count: number): Error =>
  new Error(
    `traceStrokes: the picture seems to have ${count} strokes, but a swatch has at most ${MOST_STROKES}; cut the picture down to one swatch, in even light.`,
  );

/** Removes strokes that are far shorter and smaller than the others: dust and the grain of the paper. */
function withoutDust(strokes: TracedStroke[]): TracedStroke[] {
  const lengths = strokes.map(lengthOf);
  const areas = strokes.map(({ widths }, i) => lengths[i] * meanOf(widths));
  // Half of all ink lies in strokes of at least this area.
  const order = areas.map((_, i) => i).sort((a, b) => areas[b] - areas[a]);
  const half = 0.5 * areas.reduce((sum, area) => sum + area, 0);
  let sum = 0;
  const typical = order.find((i) => {
    sum += areas[i];
    return sum >= half;
  });
  if (typical === undefined) return [];
  return strokes.filter((_, i) => areas[i] > 0.03 * areas[typical] || lengths[i] > 0.3 * lengths[typical]);
}

function lengthOf({ xs, ys }: TracedStroke): number {
  let length = 0;
  for (let i = 1; i < xs.length; i++) length += Math.hypot(xs[i] - xs[i - 1], ys[i] - ys[i - 1]);
  return length;
}

const meanOf = (values: Float64Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;

/** A stroke in millimetres, with as many points as its width and length need. */
function handStroke(stroke: TracedStroke, scale: number, swatch: SwatchTone | undefined): HandStroke {
  const { xs, ys, widths } = stroke;
  const spacing = Math.max(2, 0.5 * meanOf(widths), lengthOf(stroke) / (MOST_POINTS - 1));
  const line: number[] = [];
  for (let i = 0; i < xs.length; i++) line.push(xs[i], ys[i]);
  const path = resample(line, spacing);
  const points: number[] = [];
  // The centre of the first pixel lies half a pixel from the corner.
  path.xs.forEach((x, i) => {
    points.push(rounded((x + 0.5) * scale), rounded((path.ys[i] + 0.5) * scale));
  });
  const count = path.xs.length;
  const result = Array.from({ length: count }, (_, i) => {
    const at = (i / (count - 1)) * (widths.length - 1);
    const before = Math.min(widths.length - 2, Math.floor(at));
    // Widths are above 0, even at a point.
    return rounded(
      scale * Math.max(LEAST_WIDTH, widths[before] + (at - before) * (widths[before + 1] - widths[before])),
    );
  });
  return { points, widths: result, ...(swatch && { swatch }) };
}

/** Rounds to about a thousandth of a millimetre, which makes short files. */
const rounded = (value: number): number => Number(value.toPrecision(value < 1 ? 3 : 5));

/**
 * Removes connected ink that is too wide for strokes: blots, and the dark around a sheet of paper.
 *
 * @param mask 1 for ink; changed in place
 * @param distances the distance of every pixel to paper
 * @param widest the greatest distance to paper that a stroke may have, in pixels
 */
function dropBlots(mask: Uint8Array, distances: Float32Array, width: number, widest: number): void {
  const piece: number[] = [];
  for (let i = 0; i < distances.length; i++) {
    if (!mask[i] || distances[i] <= widest) continue;
    piece.push(i);
    mask[i] = 0;
    for (let pixel = piece.pop(); pixel !== undefined; pixel = piece.pop()) {
      for (const next of [pixel - 1, pixel + 1, pixel - width, pixel + width]) {
        if (!mask[next]) continue;
        mask[next] = 0;
        piece.push(next);
      }
    }
  }
}

/** Bins of the angles of strokes, from 0 to 180 degrees. */
const BINS = 36;

/**
 * Gives strokes a likely direction of drawing, in place. Ink does not show it, but the strokes of a layer are drawn one way: the direction
 * reverses at the angle that the fewest strokes have, and most strokes go to the right.
 */
function directStrokes(strokes: readonly TracedStroke[]): void {
  const chords = strokes.map(({ xs, ys }) => ({ x: xs[xs.length - 1] - xs[0], y: ys[ys.length - 1] - ys[0] }));
  const cut = emptiestAngle(chords);
  const turned = chords.map(({ x, y }) => Math.sin(Math.atan2(y, x) - cut) < 0);
  let right = 0;
  chords.forEach(({ x }, i) => {
    right += turned[i] ? -x : x;
  });
  strokes.forEach(({ xs, ys, widths }, i) => {
    if (turned[i] === right >= 0) for (const values of [xs, ys, widths]) values.reverse();
  });
}

function emptiestAngle(chords: readonly { x: number; y: number }[]): number {
  const lengths = new Float64Array(BINS);
  for (const { x, y } of chords) {
    const turn = (((Math.atan2(y, x) / Math.PI) % 1) + 1) % 1;
    lengths[Math.min(BINS - 1, Math.floor(turn * BINS))] += Math.hypot(x, y);
  }
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  for (let bin = 0; bin < BINS; bin++) {
    let sum = 0;
    // Bins nearby count too, so that the middle of the widest gap is found.
    for (let away = -8; away <= 8; away++) {
      sum += lengths[(bin + away + BINS) % BINS] / (1 + away * away);
    }
    if (sum >= least) continue;
    least = sum;
    best = bin;
  }
  return ((best + 0.5) * Math.PI) / BINS;
}
