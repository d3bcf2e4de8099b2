import type { ViewMeasures } from './measureView.js';

/** A view from a direction, in degrees, with what is measured of it. */
export interface MeasuredView {
  azimuth: number;
  elevation: number;
  measures: ViewMeasures;
}

/** How the parts of a surface lie along a horizontal direction. */
interface Lengthwise {
  /** The length along the direction, in heights. */
  length: number;
  /** How far the upper quarter lies ahead of the middle, and the lowest tenth, in standard deviations. */
  top: number;
  foot: number;
  /** The third moment: below 0 if a thin part, such as a tail, reaches far back. */
  skew: number;
  /** The logarithm of the area of the first quarter of the length, divided by that of the last one. */
  ends: number;
}

/**
 * Weights of what tells the front of a thing from its back, by the sign that most things agree on: faces, animals, figures, vehicles and
 * tools alike. Lengthwise measures matter less for what is flat.
 */
const WEIGHTS = {
  /** Per unit of the logarithm of front ÷ back. */
  relief: 1.5,
  inner: 0.7,
  /** Against the share of backs. */
  backs: 3,
  /** A thin part points backwards. */
  skew: 0.8,
  ends: 0.3,
  /** The head of an animal is above and ahead. */
  top: 0.6,
  /** Toes and the feet of chairs point forwards. */
  foot: 0.8,
  /** Formats have +z face forwards; about half of all files keep to it. */
  convention: 0.2,
} as const;
/** What is at least this long, in heights, has its head at an end, as animals do; others stand on feet, as figures do. */
const LONG = 0.7;
const MOST_RELIEF = 1;
const MOST_FOOT = 0.7;
/** Views within 60 degrees count for a side, from up to this elevation. */
const LEAST_COSINE = 0.3;
const HIGHEST = 30;
const NOTHING = 1e-3;

/**
 * How clearly a horizontal direction is the front of a surface: about −2 to 2.
 *
 * @param points spread evenly over the surface, as xyz
 */
export function frontEvidence(points: Float32Array, views: readonly MeasuredView[], azimuth: number): number {
  const around = (azimuth * Math.PI) / 180;
  const { length, top, foot, skew, ends } = lengthwise(points, Math.sin(around), Math.cos(around));
  const low = views.filter(({ elevation }) => elevation <= HIGHEST);
  const mean = (key: 'relief' | 'inner' | 'backs', sign: number): number => {
    const seen = low.filter((view) => sign * Math.cos((view.azimuth * Math.PI) / 180 - around) > LEAST_COSINE);
    return seen.reduce((sum, { measures }) => sum + measures[key], 0) / seen.length;
  };
  const ratio = (key: 'relief' | 'inner'): number => Math.log((mean(key, 1) + NOTHING) / (mean(key, -1) + NOTHING));
  const whole = Math.min(1, length);
  return (
    WEIGHTS.relief * clamp(ratio('relief'), MOST_RELIEF) +
    WEIGHTS.inner * clamp(ratio('inner'), MOST_RELIEF) -
    WEIGHTS.backs * (mean('backs', 1) - mean('backs', -1)) -
    WEIGHTS.skew * whole * skew +
    WEIGHTS.ends * whole * ends +
    (length > LONG ? WEIGHTS.top * top : WEIGHTS.foot * clamp(foot, MOST_FOOT)) +
    WEIGHTS.convention * Math.cos(around)
  );
}

const clamp = (value: number, most: number): number => Math.max(-most, Math.min(most, value));

/** The length of a surface along a horizontal direction, in heights. @param points spread evenly over it, as xyz */
export const lengthAlong = (points: Float32Array, azimuth: number): number =>
  lengthwise(points, Math.sin((azimuth * Math.PI) / 180), Math.cos((azimuth * Math.PI) / 180)).length;

function lengthwise(points: Float32Array, x: number, z: number): Lengthwise {
  const count = points.length / 3;
  let [middle, low, high, bottom, top] = [0, Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    const place = points[i] * x + points[i + 2] * z;
    middle += place / count;
    low = Math.min(low, place);
    high = Math.max(high, place);
    bottom = Math.min(bottom, points[i + 1]);
    top = Math.max(top, points[i + 1]);
  }
  const sums = { square: 0, cube: 0, top: 0, inTop: 0, foot: 0, inFoot: 0, first: 0, last: 0 };
  const quarter = (high - low) / 4;
  const height = Math.max(top - bottom, 1e-6);
  for (let i = 0; i < points.length; i += 3) {
    const along = points[i] * x + points[i + 2] * z;
    const place = along - middle;
    const above = (points[i + 1] - bottom) / height;
    sums.square += place ** 2 / count;
    sums.cube += place ** 3 / count;
    if (above > 0.75) {
      sums.top += place;
      sums.inTop++;
    } else if (above < 0.1) {
      sums.foot += place;
      sums.inFoot++;
    }
    if (along > high - quarter) sums.first++;
    else if (along < low + quarter) sums.last++;
  }
  const deviation = Math.max(Math.sqrt(sums.square), 1e-6);
  return {
    length: (high - low) / height,
    top: sums.inTop > 0 ? sums.top / sums.inTop / deviation : 0,
    foot: sums.inFoot > 0 ? sums.foot / sums.inFoot / deviation : 0,
    skew: sums.cube / deviation ** 3,
    ends: Math.log((sums.first / count + 0.02) / (sums.last / count + 0.02)),
  };
}
