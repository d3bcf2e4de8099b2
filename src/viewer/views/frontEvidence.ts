import type { Landmark } from './landmarks.js';
import type { ViewMeasures } from './measureView.js';

/** A view from a direction, in degrees, with what is measured of it. */
export interface MeasuredView {
  azimuth: number;
  elevation: number;
  measures: ViewMeasures;
}

/** What is known of a surface before its views are compared. */
export interface FrontClues {
  /** Spread evenly over the surface, as xyz. */
  points: Float32Array;
  /** The share of the surface that faces along its three axes: much of furniture and vehicles, little of animals and figures. */
  squareness: number;
  /** Parts whose names say whether they are in front. */
  landmarks: readonly Landmark[];
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
  /** How much higher the front half reaches than the rear half, on average, in heights. */
  rise: number;
  /** How far parts that are named for the front lie ahead of the middle, or those for the rear behind it, in half lengths. */
  named: number;
}

/**
 * Weights of what tells the front of a thing from its back, by the sign that most things agree on: faces, animals, figures, vehicles and
 * tools alike. They were fitted to 105 models whose fronts are known, and to 803 models for furnishing houses.
 */
const WEIGHTS = {
  /** Per unit of the logarithm of front ÷ back. */
  relief: 1.5,
  inner: 0.5,
  /** Of furniture and vehicles, whose backs are often left open, both tell less. */
  ofThings: 0.4,
  /** Against the share of backs. */
  backs: 2,
  /** A thin part points backwards. */
  skew: 0.6,
  /** Slopes that face upwards, such as windscreens, seats and keyboards, are in front, but less so of animals. */
  slopes: 2.8,
  ofAnimals: 0.5,
  /** Of furniture and vehicles: bonnets, seats and steps are low and in front; backrests, cabs and cisterns are high and behind. */
  rise: 2.3,
  high: 0.6,
  /** Of animals and figures: the head is above and ahead, and toes point forwards. */
  head: 0.5,
  foot: 0.6,
  named: 2.5,
  /** Formats have +z face forwards; about half of all files keep to it. */
  convention: 0.15,
} as const;
/** What is at least this long, in heights, has its head at an end, as animals do; others stand on feet, as figures do. */
const LONG = 0.7;
/** A surface is that of an animal or a figure below the first squareness, and that of furniture or a vehicle above the second. */
const SQUARE = { least: 0.4, full: 0.55 };
const MOST = { relief: 1, foot: 0.7, slopes: 1 / 3, rise: 1 / 3, top: 1, backs: 0.5 };
/** Views within 60 degrees count for a side, from up to this elevation. */
const LEAST_COSINE = 0.3;
const HIGHEST = 30;
const NOTHING = 1e-3;

/** How clearly a horizontal direction is the front of a surface: about −2 to 2. */
export function frontEvidence(clues: FrontClues, views: readonly MeasuredView[], azimuth: number): number {
  const around = (azimuth * Math.PI) / 180;
  const { length, top, foot, skew, rise, named } = lengthwise(clues, Math.sin(around), Math.cos(around));
  const low = views.filter(({ elevation }) => elevation <= HIGHEST);
  const mean = (key: 'relief' | 'inner' | 'backs' | 'slopes', sign: number): number => {
    const seen = low.filter((view) => sign * Math.cos((view.azimuth * Math.PI) / 180 - around) > LEAST_COSINE);
    return seen.reduce((sum, { measures }) => sum + measures[key], 0) / seen.length;
  };
  const ratio = (key: 'relief' | 'inner'): number => Math.log((mean(key, 1) + NOTHING) / (mean(key, -1) + NOTHING));
  const more = (key: 'backs' | 'slopes'): number => clamp(mean(key, 1) - mean(key, -1), MOST[key]);
  const square = Math.max(0, Math.min(1, (clues.squareness - SQUARE.least) / (SQUARE.full - SQUARE.least)));
  const slopes = WEIGHTS.slopes * more('slopes');
  const ofThing = slopes - WEIGHTS.rise * clamp(rise, MOST.rise) - WEIGHTS.high * clamp(top, MOST.top);
  const headOrFoot = length > LONG ? WEIGHTS.head * top : WEIGHTS.foot * clamp(foot, MOST.foot);
  const ofAnimal = WEIGHTS.ofAnimals * slopes + headOrFoot;
  const detail =
    WEIGHTS.relief * clamp(ratio('relief'), MOST.relief) + WEIGHTS.inner * clamp(ratio('inner'), MOST.relief);
  return (
    (1 - square + WEIGHTS.ofThings * square) * detail -
    WEIGHTS.backs * more('backs') -
    WEIGHTS.skew * Math.min(1, length) * skew +
    square * ofThing +
    (1 - square) * ofAnimal +
    WEIGHTS.named * clamp(named, 1) +
    WEIGHTS.convention * Math.cos(around)
  );
}

const clamp = (value: number, most: number): number => Math.max(-most, Math.min(most, value));

/** The length of a surface along a horizontal direction, in heights. */
export const lengthAlong = (clues: FrontClues, azimuth: number): number =>
  lengthwise(clues, Math.sin((azimuth * Math.PI) / 180), Math.cos((azimuth * Math.PI) / 180)).length;

/** Slices across the length, in each of which the highest point counts. */
const SLICES = 10;

function lengthwise({ points, landmarks }: FrontClues, x: number, z: number): Lengthwise {
  const extent = extentAlong(points, x, z);
  const { low, high } = extent;
  const height = Math.max(extent.top - extent.bottom, 1e-6);
  const moments = momentsAlong(points, x, z, extent, height);
  const deviation = Math.max(Math.sqrt(moments.square), 1e-6);
  const named = landmarks.reduce((sum, landmark) => {
    const place = landmark.x * x + landmark.z * z;
    return sum + landmark.sign * (place - (low + high) / 2);
  }, 0);
  const rise = moments.tops.reduce((sum, top, slice) => sum + (slice < SLICES / 2 ? -top : top), 0);
  return {
    length: (high - low) / height,
    top: moments.inTop > 0 ? moments.top / moments.inTop / deviation : 0,
    foot: moments.inFoot > 0 ? moments.foot / moments.inFoot / deviation : 0,
    skew: moments.cube / deviation ** 3,
    rise: rise / (SLICES / 2),
    named: landmarks.length > 0 ? (2 * named) / Math.max(high - low, 1e-6) / landmarks.length : 0,
  };
}

/** How far points reach along a direction and upwards, and their mean place along the direction. */
interface Extent {
  middle: number;
  low: number;
  high: number;
  bottom: number;
  top: number;
}

function extentAlong(points: Float32Array, x: number, z: number): Extent {
  let sum = 0;
  let low = Infinity;
  let high = -Infinity;
  let bottom = Infinity;
  let top = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    const place = points[i] * x + points[i + 2] * z;
    sum += place;
    low = Math.min(low, place);
    high = Math.max(high, place);
    bottom = Math.min(bottom, points[i + 1]);
    top = Math.max(top, points[i + 1]);
  }
  return { middle: (3 * sum) / points.length, low, high, bottom, top };
}

/** Moments of points along a direction about their mean place, and sums over those high up and those at the foot. */
interface Moments {
  square: number;
  cube: number;
  top: number;
  inTop: number;
  foot: number;
  inFoot: number;
  /** The highest point of each slice, as a share of the height. */
  tops: Float64Array;
}

function momentsAlong(
  points: Float32Array,
  x: number,
  z: number,
  { middle, low, high, bottom }: Extent,
  height: number,
): Moments {
  const tops = new Float64Array(SLICES);
  const perSlice = SLICES / Math.max(high - low, 1e-6);
  let square = 0;
  let cube = 0;
  let top = 0;
  let inTop = 0;
  let foot = 0;
  let inFoot = 0;
  for (let i = 0; i < points.length; i += 3) {
    const along = points[i] * x + points[i + 2] * z;
    const place = along - middle;
    const above = (points[i + 1] - bottom) / height;
    square += place * place;
    cube += place * place * place;
    if (above > 0.75) {
      top += place;
      inTop++;
    } else if (above < 0.1) {
      foot += place;
      inFoot++;
    }
    const slice = Math.min(SLICES - 1, Math.floor(perSlice * (along - low)));
    if (above > tops[slice]) tops[slice] = above;
  }
  const share = 3 / points.length;
  return { square: share * square, cube: share * cube, top, inTop, foot, inFoot, tops };
}
