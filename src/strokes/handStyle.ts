import type { HandNumbers } from './hand/Hand.js';
import { type PreparedHand, prepareHand } from './prepareHand.js';
import { makeProfile } from './Stroke.js';
import type { PlacingHabit } from './StrokeDensityField.js';
import type { StrokeLayer, StrokeStyle } from './StrokeStyle.js';
import { STROKE_WIDTHS } from './strokeStyleNames.js';
import type { MapRequest } from './tamImages/generateHatchImages.js';
import { type MapDrawing, resolveMapDrawing } from './tamImages/hatchImageOptions.js';

/** The longest stroke of a map, in tiles: a longer one would run beside itself too often. */
const LONGEST = 1.5;

/** Least length of the last stroke of a tone, as a share of the mean, so that the tone reaches its mean ink; shorter on coarse levels. */
const SHORTEST = 0.8;

/** Least number of proposals per stroke, so that the tile is even as a whole. */
const LEAST_PROPOSALS = 20;

/** Strokes shorter than this, in tiles, need fewer proposals, each of which takes longer. */
const SHORT = 0.15;

/** The largest share of strokes placed beside the previous one in a bundle, and their least distance. */
const MOST_BUNDLED = 0.6;
const CLOSEST_WIDTHS = 1.4;

/** Copies of a stroke are up to this much longer or shorter. */
const SCALE_SPREAD = 0.04;

/** Strokes with a flatter arc count as straight. */
const STRAIGHT = 0.02;

/**
 * The style in which a hand draws. The width of the hand becomes `strokeTexels`, and everything else follows at the same scale.
 *
 * @param size texels per side of the finest level
 */
export function handStyle(
  { shapes: prepared, numbers, mirror }: PreparedHand,
  strokeTexels: number,
  size: number,
): StrokeStyle {
  const tilesPerMillimetre = strokeTexels / (numbers.width * size);
  const shapes = prepared.map(({ length, offset, width }) => ({
    length: Math.min(LONGEST, length * tilesPerMillimetre),
    profile: makeProfile(offset, width),
  }));
  const mean = shapes.reduce((sum, { length }) => sum + length, 0) / shapes.length;
  const longest = shapes.reduce((most, { length }) => Math.max(most, length), 0);
  const maxInk = inkOf(numbers);
  const proposals = proposalsOf(numbers, longest < SHORT);
  const thresholdInk = numbers.crossingAngle === 0 ? 0.54 : 0.6;
  return {
    length: [SHORTEST * mean, longest],
    width: strokeTexels,
    widthRange: STROKE_WIDTHS.hatching.widthRange,
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

/** The ink of the darkest tone: twice that of the middle swatch, within limits at which lines are visible. */
const inkOf = ({ width, spacing }: HandNumbers): number => Math.max(0.7, Math.min(0.95, (2 * width) / spacing));

/** The placing habit given by the numbers. */
function habitOf({ spacingSpread, overlap }: HandNumbers): PlacingHabit {
  const chance = Math.min(1, spacingSpread);
  return {
    softness: 1 + 5 * chance,
    apart: 1 - chance,
    share: Math.max(0.5, Math.min(1.6, 1 - overlap)),
  };
}

/**
 * The bundles given by the numbers. Strokes in a bundle are closer than the mean of the middle swatch by the ratio of the median distance
 * to it.
 */
function bundlesOf({ clustering, spacing, width }: HandNumbers, strokeTexels: number) {
  const texels = ((1 - clustering) * spacing * strokeTexels) / width;
  return {
    bundled: Math.min(MOST_BUNDLED, 4 * clustering),
    bundleSpacing: Math.max(CLOSEST_WIDTHS * strokeTexels, texels),
  };
}

/** The number of proposals per stroke: hands that place strokes at random search less for the best place. */
function proposalsOf({ spacingSpread }: HandNumbers, isShort: boolean): number {
  const even = 1 - Math.min(1, spacingSpread);
  return Math.round((isShort ? 80 : 400) * even * even) + LEAST_PROPOSALS;
}

/** The layers: the first runs along u, the second at its angle to it. On the sheet y goes down, on the map v goes up. */
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

/**
 * Makes the request for a map, with the style of its hand if it has one. It takes a few milliseconds. It is not part of the worker, which
 * every page loads.
 *
 * @throws TypeError or RangeError for an invalid hand; yields progress in [0, 1]
 */
export function* requestOfHand({ hand, ...drawing }: MapDrawing): Generator<number, MapRequest, void> {
  if (!hand) return drawing;
  const { strokeTexels, size } = resolveMapDrawing(drawing);
  return { ...drawing, hand: handStyle(yield* prepareHand(hand), strokeTexels, size) };
}
