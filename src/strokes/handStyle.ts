import type { Hand, HandNumbers } from '../hand/Hand.js';
import { arcAt, measureStroke, type StrokeMeasure } from '../hand/measureStroke.js';
import { distance, polylineOf, resample } from '../hand/Polyline.js';
import { separateLayers } from '../hand/separateLayers.js';
import { splitAtTurns } from '../hand/splitAtTurns.js';
import { type Random, random } from './random.js';
import type { PlacingHabit } from './StrokeDensityField.js';
import { makeProfile, PROFILE_SAMPLES, type StrokeProfile } from './StrokeProfile.js';
import type { StrokeLayer, StrokeStyle } from './StrokeStyle.js';
import { HAND_WIDTHS } from './strokeWidths.js';

/** The longest stroke of a map, in tiles: a longer one would lie beside itself too often. */
const LONGEST = 1.5;

/** The last stroke of a tone may be as short as this share of the mean, so that the tone has its mean; on coarse levels shorter. */
const SHORTEST = 0.8;

/** Fewer strokes than this are drawn in several variants, where numbers ask for more spread than the strokes have. */
const LEAST_SHAPES = 40;

/** A hand has a spread or a wobble of its own if it is at least this share of what is asked for; otherwise chance makes it. */
const OWN_SHARE = 0.25;

/** A stroke has at least so many proposals, so that the tile is even as a whole. */
const LEAST_PROPOSALS = 20;

/** Of strokes shorter than this, in tiles, a proposal takes longer, and fewer are enough. */
const SHORT = 0.15;

/** The largest share of strokes that follow the one before them in a bundle, and how close they come. */
const MOST_BUNDLED = 0.6;
const CLOSEST_WIDTHS = 1.4;

/** Copies of a stroke are up to this much longer or shorter. */
const SCALE_SPREAD = 0.04;

/** Strokes with less of an arc count as straight. */
const STRAIGHT = 0.02;

/** Waves of a wobble that chance makes, per stroke. */
const WAVES = 7;

/** Beside what it is meant to be, a stroke is at least and at most this long or wide. */
const [LEAST_FACTOR, MOST_FACTOR] = [0.3, 2.5];

/**
 * The style in which a hand draws: its own strokes, warped so that their numbers are those of the hand, which may have been changed
 * since they were learnt. The width of the hand becomes `strokeTexels`, and everything else follows at the same scale.
 *
 * @param size texels per side of the finest level
 */
export function handStyle({ strokes, numbers, mirror = false }: Hand, strokeTexels: number, size: number): StrokeStyle {
  const pieces = strokes.flatMap((stroke) =>
    splitAtTurns(polylineOf(stroke)).map((line) => measureStroke(line, stroke.swatch ?? 'middle')),
  );
  if (pieces.length === 0) throw new RangeError('hand: all strokes are dots; draw strokes longer than wide.');
  const tilesPerMillimetre = strokeTexels / (numbers.width * size);
  const shapes = shapesOf(pieces, numbers).map(({ length, profile }) => ({
    length: Math.min(LONGEST, length * tilesPerMillimetre),
    profile,
  }));
  const mean = shapes.reduce((sum, { length }) => sum + length, 0) / shapes.length;
  const longest = shapes.reduce((most, { length }) => Math.max(most, length), 0);
  const maxInk = inkOf(numbers);
  const proposals = proposalsOf(numbers, longest < SHORT);
  const thresholdInk = numbers.crossingAngle === 0 ? 0.54 : 0.6;
  return {
    length: [SHORTEST * mean, longest],
    width: strokeTexels,
    widthRange: HAND_WIDTHS.widthRange,
    widthSpread: 0,
    taper: 0,
    slope: 0,
    bow: 0,
    wave: 0,
    maxInk,
    layers: layersOf(numbers, maxInk, thresholdInk),
    proposals,
    thresholds: { maxInk: thresholdInk, swell: 0.15, proposals },
    hand: {
      shapes,
      angleSpread: (numbers.angleSpread * Math.PI) / 180,
      scaleSpread: SCALE_SPREAD,
      isCurved: Math.abs(numbers.curvature) > STRAIGHT,
      mirror,
      habit: habitOf(numbers),
      ...bundlesOf(numbers, strokeTexels),
    },
  };
}

/** The ink of the darkest tone: twice that of the middle swatch, as far as lines are still seen. */
const inkOf = ({ width, spacing }: HandNumbers): number => Math.max(0.7, Math.min(0.95, (2 * width) / spacing));

/** How the numbers place strokes. */
function habitOf({ spacingSpread, overlap }: HandNumbers): PlacingHabit {
  const chance = Math.min(1, spacingSpread);
  return {
    softness: 1 + 5 * chance,
    apart: 1 - chance,
    share: Math.max(0.5, Math.min(1.6, 1 - overlap)),
  };
}

/** Strokes of a bundle stand closer than the mean of the middle swatch, as the median of its distances does. */
function bundlesOf({ clustering, spacing, width }: HandNumbers, strokeTexels: number) {
  const texels = ((1 - clustering) * spacing * strokeTexels) / width;
  return {
    bundled: Math.min(MOST_BUNDLED, 4 * clustering),
    bundleSpacing: Math.max(CLOSEST_WIDTHS * strokeTexels, texels),
  };
}

/** How many proposals there are for a stroke: hands that place by chance look less far for the best place. */
function proposalsOf({ spacingSpread }: HandNumbers, isShort: boolean): number {
  const even = 1 - Math.min(1, spacingSpread);
  return Math.round((isShort ? 80 : 400) * even * even) + LEAST_PROPOSALS;
}

/** The first layer runs along u, the second at its angle to it. On the sheet y goes down, on the map v goes up. */
function layersOf({ crossingAngle, crossingFrom }: HandNumbers, maxInk: number, thresholdInk: number): StrokeLayer[] {
  const first = { across: false, slope: 0, from: 0, thresholdsFrom: 0 };
  if (crossingAngle === 0 || crossingFrom >= 1) return [first];
  const across = Math.abs(crossingAngle) > 45;
  const slope = across ? tangent(90 - Math.abs(crossingAngle)) : tangent(Math.abs(crossingAngle));
  const from = crossingFrom;
  return [
    first,
    { across, slope: crossingAngle > 0 ? -slope : slope, from: from * maxInk, thresholdsFrom: from * thresholdInk },
  ];
}

/** The tangent of 0 to 45 degrees, by arithmetic that is rounded the same on every machine. */
function tangent(degrees: number): number {
  const x = (degrees * Math.PI) / 180;
  const x2 = x * x;
  return (x * (945 - 105 * x2 + x2 * x2)) / (945 - 420 * x2 + 15 * x2 * x2);
}

/** The strokes, warped to the numbers: chord in millimetres, and shape as it lies along its layer. */
function shapesOf(
  pieces: readonly StrokeMeasure[],
  numbers: HandNumbers,
): { length: number; profile: StrokeProfile }[] {
  const next = random(pieces.length);
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
    // As far as the samples of a profile hold it.
    wobble: Math.sqrt(meanOf(pieces, (piece) => squareOf(sampled.get(piece)!.residual) * chordOf(piece) ** 2)),
    ...widthsOf(pieces),
  };
  const lengthSpread = Math.sqrt(meanOf(pieces, ({ length }) => (length / own.length - 1) ** 2));
  const count = Math.max(LEAST_SHAPES, pieces.length);
  return Array.from({ length: count }, (_, i) => {
    const piece = pieces[i % pieces.length];
    const length = numbers.length * spreadTo(piece.length / own.length, lengthSpread, numbers.lengthSpread, next);
    const turn = numbers.curvature - own.curvature;
    const profile = profileOf(
      piece,
      {
        curvature: piece.curvature + (backwards.has(piece) ? -turn : turn),
        // Shares of the chord, which becomes longer or shorter.
        wobble: { own: own.wobble / piece.length, wanted: numbers.wobble / length },
        samples: sampled.get(piece)!,
        width: own.width,
        widthSpread: { own: own.widthSpread, wanted: numbers.widthSpread },
        taperStart: taperOf(piece.tapers.start, own.taperStart, numbers.taperStart),
        taperEnd: taperOf(piece.tapers.end, own.taperEnd, numbers.taperEnd),
      },
      next,
    );
    return {
      length: (length * chordOf(piece)) / piece.length,
      profile: backwards.has(piece) ? profile.turned : profile,
    };
  });
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

/** A factor whose spread is `own`, brought to the spread that is wanted; by chance if it has hardly any of its own. */
function spreadTo(factor: number, own: number, wanted: number, next: Random): number {
  const deviation =
    own >= OWN_SHARE * wanted
      ? (factor - 1) * (own > 0 ? wanted / own : 0)
      : wanted * (2 * (next() + next() + next()) - 3);
  return Math.max(LEAST_FACTOR, Math.min(MOST_FACTOR, 1 + deviation));
}

/** The taper of a stroke if the mean of all is brought to the one that is wanted. */
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
function profileOf(piece: StrokeMeasure, warp: Warp, next: Random): StrokeProfile {
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
  return makeProfile(offset, widthsAlong(piece, width, warp, next));
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
    // From end to end of what was drawn, which may reach a little beyond its smooth arc.
    const x = along[0] + 0.5 * (xOf(i) + 1) * (along[last] - along[0]);
    while (at < last - 1 && along[at + 1] < x) at++;
    const step = along[at + 1] - along[at];
    const share = step > 0 ? Math.max(0, Math.min(1, (x - along[at]) / step)) : 0;
    residual[i] = beside[at] + share * (beside[at + 1] - beside[at]) - curvature * (1 - x * x);
    width[i] = line.width[at] + share * (line.width[at + 1] - line.width[at]);
  }
  return { residual, width };
}

/** A wobble of this root mean square, by chance. */
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

/** The width along a stroke, as a share: its pressure brought to the spread and its tapers to the lengths that are wanted. */
function widthsAlong({ tapers }: StrokeMeasure, width: Float32Array, warp: Warp, next: Random): Float32Array {
  const { own, wanted } = warp.widthSpread;
  const byChance = own >= OWN_SHARE * wanted ? 1 : spreadTo(1, 0, wanted, next);
  const pressureAt = (share: number): number => {
    const kept = Math.max(tapers.start, Math.min(1 - tapers.end, share));
    return byChance * spreadTo(valueAt(width, kept) / warp.width, own, own >= OWN_SHARE * wanted ? wanted : own, next);
  };
  // Ends keep the form in which they narrow.
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
