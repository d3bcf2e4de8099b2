import { checkHand } from './hand/checkHand.js';
import type { Hand, HandNumbers, SwatchTone } from './hand/Hand.js';
import { arcAt, measureStroke, type StrokeMeasure } from './hand/measureStroke.js';
import { distance, type Polyline, polylineOf, resample, splitAtTurns } from './hand/Polyline.js';
import { separateLayers } from './hand/separateLayers.js';
import { type Random, random } from './random.js';
import { PROFILE_SAMPLES } from './Stroke.js';

/** With fewer strokes, several variants of each are drawn where the numbers ask for more spread than the strokes have. */
const LEAST_SHAPES = 40;

/** A hand has a spread or wobble of its own if it is at least this share of the wanted one; otherwise it is random. */
const OWN_SHARE = 0.25;

/** Waves of a random wobble, per stroke. */
const WAVES = 7;

/** Bounds of the length and the width of a stroke, relative to the intended ones. */
const [LEAST_FACTOR, MOST_FACTOR] = [0.3, 2.5];

/** Largest number of strokes that maps are drawn with. */
const MOST_STROKES = 1000;

/** A hand in the form in which maps are drawn with it. */
export interface PreparedHand {
  /** Its strokes, warped to the numbers, in the direction of their layer. */
  shapes: readonly {
    /** The chord, in millimetres. */
    length: number;
    /** See `StrokeProfile`. */
    offset: Float32Array;
    width: Float32Array;
    swatch: SwatchTone;
  }[];
  numbers: HandNumbers;
  mirror: boolean;
}

type Shape = PreparedHand['shapes'][number];
type Drawn = Pick<Shape, 'offset' | 'width'>;

/** Strokes measured between two yields, in about a millisecond. */
const STROKES_PER_SLICE = 50;

/**
 * Prepares a hand for maps: measures its strokes, and warps them to the numbers of the hand, which may have been changed since they were
 * learnt.
 *
 * Everything that is drawn uses only arithmetic that IEEE 754 rounds exactly, so the same hand gives the same map on every machine.
 *
 * @param caller what the errors name
 * @param most the largest number of strokes that are used, evenly selected; dots do not count
 * @throws TypeError or RangeError with the fault of the hand, at the first steps; yields progress in [0, 1]
 */
export function* prepareHand(
  hand: Hand,
  caller = 'TonalArtMap',
  most = MOST_STROKES,
): Generator<number, PreparedHand, void> {
  checkHand(caller, hand);
  const { numbers, mirror = false } = hand;
  const strokes: { lines: Polyline[]; swatch: SwatchTone }[] = [];
  for (const [index, stroke] of hand.strokes.entries()) {
    const lines = splitAtTurns(polylineOf(stroke));
    if (lines.length > 0) strokes.push({ lines, swatch: stroke.swatch ?? 'middle' });
    if (index % STROKES_PER_SLICE === STROKES_PER_SLICE - 1) yield (0.3 * index) / hand.strokes.length;
  }
  if (strokes.length === 0)
    throw new RangeError(`${caller}: hand: all strokes are dots; draw strokes longer than wide.`);
  const used = Math.min(most, strokes.length);
  const pieces: StrokeMeasure[] = [];
  for (let i = 0; i < used; i++) {
    const { lines, swatch } = strokes[Math.floor((i * strokes.length) / used)];
    for (const line of lines) pieces.push(measureStroke(line, swatch));
    if (i % STROKES_PER_SLICE === STROKES_PER_SLICE - 1) yield 0.3 + (0.2 * i) / used;
  }

  const next = random(pieces.length);
  const shapes: Shape[] = [];
  const backwards = new Set(
    separateLayers(pieces).flatMap(({ strokes, angle }) =>
      strokes.filter((stroke) => Math.cos(stroke.angle - angle) < 0),
    ),
  );
  const curvatureOf = (piece: StrokeMeasure): number => (backwards.has(piece) ? -piece.curvature : piece.curvature);
  const sampled = new Map(pieces.map((piece) => [piece, samplesOf(piece)]));
  const own = {
    length: meanOf(pieces, ({ length }) => length),
    curvature: meanOf(pieces, curvatureOf),
    taperStart: meanOf(pieces, ({ tapers }) => tapers.start),
    taperEnd: meanOf(pieces, ({ tapers }) => tapers.end),
    // The part that the samples of a profile resolve.
    wobble: Math.sqrt(meanOf(pieces, (piece) => squareOf(sampled.get(piece)!.residual) * chordOf(piece) ** 2)),
    ...widthsOf(pieces),
  };
  const lengthSpread = Math.sqrt(meanOf(pieces, ({ length }) => (length / own.length - 1) ** 2));
  const count = Math.max(LEAST_SHAPES, pieces.length);
  for (let i = 0; i < count; i++) {
    const piece = pieces[i % pieces.length];
    const length = numbers.length * spreadTo(piece.length / own.length, lengthSpread, numbers.lengthSpread, next);
    const turn = numbers.curvature - own.curvature;
    const shape = shapeOf(
      piece,
      {
        curvature: piece.curvature + (backwards.has(piece) ? -turn : turn),
        // As a share of the chord, whose length changes.
        wobble: { own: own.wobble / piece.length, wanted: numbers.wobble / length },
        samples: sampled.get(piece)!,
        width: own.width,
        widthSpread: { own: own.widthSpread, wanted: numbers.widthSpread },
        taperStart: taperOf(piece.tapers.start, own.taperStart, numbers.taperStart),
        taperEnd: taperOf(piece.tapers.end, own.taperEnd, numbers.taperEnd),
      },
      next,
    );
    // A stroke that was drawn backwards is turned to the direction of its layer.
    if (backwards.has(piece)) turnAround(shape);
    shapes.push({ length: (length * chordOf(piece)) / piece.length, ...shape, swatch: piece.swatch });
    if (i % STROKES_PER_SLICE === STROKES_PER_SLICE - 1) yield 0.5 + (0.5 * i) / count;
  }
  return { shapes, numbers, mirror };
}

/** Turns a shape by half a turn. */
function turnAround({ offset, width }: Drawn): void {
  offset.reverse();
  for (let i = 0; i < offset.length; i++) offset[i] = -offset[i];
  width.reverse();
}

const chordOf = ({ forward }: StrokeMeasure): number => 2 * distance(forward[0], forward[1]);

/** The mean square along the straight lines between samples. */
function squareOf(values: Float32Array): number {
  let sum = 0;
  for (let i = 1; i < values.length; i++) sum += values[i - 1] ** 2 + values[i - 1] * values[i] + values[i] ** 2;
  return sum / (3 * (values.length - 1));
}

const meanOf = (pieces: readonly StrokeMeasure[], value: (piece: StrokeMeasure) => number): number =>
  pieces.reduce((sum, piece) => sum + value(piece), 0) / pieces.length;

function widthsOf(pieces: readonly StrokeMeasure[]): { width: number; widthSpread: number } {
  const [count, sum, squares] = [0, 1, 2].map((index) => pieces.reduce((all, { widths }) => all + widths[index], 0));
  const width = sum / count;
  return { width, widthSpread: Math.sqrt(Math.max(0, squares / count - width * width)) / width };
}

/** Scales a factor with the spread `own` to the wanted spread; random if it has hardly any of its own. */
function spreadTo(factor: number, own: number, wanted: number, next: Random): number {
  const deviation =
    own >= OWN_SHARE * wanted
      ? (factor - 1) * (own > 0 ? wanted / own : 0)
      : wanted * (2 * (next() + next() + next()) - 3);
  return Math.max(LEAST_FACTOR, Math.min(MOST_FACTOR, 1 + deviation));
}

/** The taper of a stroke after the mean of all is brought to the wanted one. */
const taperOf = (taper: number, own: number, wanted: number): number =>
  Math.min(1, own >= OWN_SHARE * wanted && own > 0 ? (taper * wanted) / own : wanted);

interface Warp {
  samples: { residual: Float32Array; width: Float32Array };
  curvature: number;
  wobble: { own: number; wanted: number };
  /** The width, in millimetres, that becomes 1. */
  width: number;
  widthSpread: { own: number; wanted: number };
  taperStart: number;
  taperEnd: number;
}

/** The shape of one stroke as it was drawn, warped. */
function shapeOf(piece: StrokeMeasure, warp: Warp, next: Random): Drawn {
  const { residual, width } = warp.samples;
  const { own, wanted } = warp.wobble;
  const wobble = own >= OWN_SHARE * wanted ? (own > 0 ? wanted / own : 0) : 0;
  const waves = wobble === 0 && wanted > 0 ? wavesOf(wanted, next) : undefined;
  const offset = new Float32Array(PROFILE_SAMPLES);
  for (let i = 0; i < PROFILE_SAMPLES; i++) {
    const x = xOf(i);
    // To the right on the sheet is down, but to the left on the map, where v goes up, is up.
    offset[i] = -(warp.curvature * (1 - x * x) + wobble * residual[i] + (waves ? waves[i] : 0));
  }
  return { offset, width: widthsAlong(piece, width, warp, next) };
}

const xOf = (sample: number): number => (2 * sample) / (PROFILE_SAMPLES - 1) - 1;

/** The distance from the smooth arc as a share of the chord, and the width in millimetres, at steady steps along the chord. */
function samplesOf(piece: StrokeMeasure): { residual: Float32Array; width: Float32Array } {
  const { forward, curvature } = piece;
  const half = distance(forward[0], forward[1]);
  const [cosine, sine] = [forward[0] / half, forward[1] / half];
  const line = resample(piece.line, 2 * PROFILE_SAMPLES);
  const last = line.path.length - 1;
  const [x0, y0] = ([0, 1] as const).map((axis) => 0.5 * (arcAt(piece, axis, -1) + arcAt(piece, axis, 1)));
  const along = line.x.map((x, i) => ((x - x0) * cosine + (line.y[i] - y0) * sine) / half);
  const beside = line.x.map((x, i) => ((line.y[i] - y0) * cosine - (x - x0) * sine) / (2 * half));
  const residual = new Float32Array(PROFILE_SAMPLES);
  const width = new Float32Array(PROFILE_SAMPLES);
  let at = 0;
  for (let i = 0; i < PROFILE_SAMPLES; i++) {
    // From end to end of the drawn stroke, which may reach a little beyond its smooth arc.
    const x = along[0] + 0.5 * (xOf(i) + 1) * (along[last] - along[0]);
    while (at < last - 1 && along[at + 1] < x) at++;
    const step = along[at + 1] - along[at];
    const share = step > 0 ? Math.max(0, Math.min(1, (x - along[at]) / step)) : 0;
    residual[i] = beside[at] + share * (beside[at + 1] - beside[at]) - curvature * (1 - x * x);
    width[i] = line.width[at] + share * (line.width[at + 1] - line.width[at]);
  }
  return { residual, width };
}

/** A random wobble of this root mean square. */
function wavesOf(wanted: number, next: Random): Float32Array {
  const knots = Array.from({ length: WAVES + 2 }, () => 2 * next() - 1);
  const waves = Float32Array.from({ length: PROFILE_SAMPLES }, (_, i) => {
    const place = (WAVES * i) / (PROFILE_SAMPLES - 1);
    const knot = Math.floor(place);
    const part = place - knot;
    const smooth = part * part * (3 - 2 * part);
    return knots[knot] + smooth * (knots[knot + 1] - knots[knot]);
  });
  const mean = waves.reduce((sum, value) => sum + value, 0) / waves.length;
  const square = waves.reduce((sum, value) => sum + (value - mean) ** 2, 0) / waves.length;
  return waves.map((value) => ((value - mean) * wanted) / Math.sqrt(square || 1));
}

/** The relative width along a stroke, with the pressure brought to the wanted spread and the tapers to the wanted lengths. */
function widthsAlong({ tapers }: StrokeMeasure, width: Float32Array, warp: Warp, next: Random): Float32Array {
  const { own, wanted } = warp.widthSpread;
  const byChance = own >= OWN_SHARE * wanted ? 1 : spreadTo(1, 0, wanted, next);
  const pressureAt = (share: number): number => {
    const kept = Math.max(tapers.start, Math.min(1 - tapers.end, share));
    return byChance * spreadTo(valueAt(width, kept) / warp.width, own, own >= OWN_SHARE * wanted ? wanted : own, next);
  };
  // The shape of the tapers stays.
  const endAt = (fromTip: number, taper: number, ownTaper: number, place: (share: number) => number): number => {
    if (taper === 0 || fromTip >= taper) return 1;
    const part = fromTip / taper;
    if (ownTaper === 0) return part;
    return valueAt(width, place(part * ownTaper)) / valueAt(width, place(ownTaper));
  };
  return Float32Array.from({ length: PROFILE_SAMPLES }, (_, i) => {
    const share = i / (PROFILE_SAMPLES - 1);
    const start = endAt(share, warp.taperStart, tapers.start, (from) => from);
    const end = endAt(1 - share, warp.taperEnd, tapers.end, (from) => 1 - from);
    return pressureAt(share) * Math.min(1, start) * Math.min(1, end);
  });
}

/** A value between samples, at a share of the way. */
function valueAt(samples: Float32Array, share: number): number {
  const place = share * (samples.length - 1);
  const first = Math.min(samples.length - 2, Math.floor(place));
  return samples[first] + (place - first) * (samples[first + 1] - samples[first]);
}
