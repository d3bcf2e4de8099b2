/** The number of samples of a profile, evenly spaced in x from −1 to 1. */
export const PROFILE_SAMPLES = 33;

/** Step in x of the slope's difference quotient: one step between samples of a profile. */
const SLOPE_STEP = 2 / (PROFILE_SAMPLES - 1);

/**
 * A stroke. Its position, length and bends are measured in tiles and its width in texels; all are the same on every level. (This
 * is the third constraint in section 3.1 of Suarez et al., in the reading of Praun et al. 2001: the width is constant in texels,
 * not the length.)
 *
 * Seen along the stroke, x from −1 at its start to 1 at its end, the centre line is displaced sideways by
 * slope·length/2·x + bow·(1 − x²) + wave·x·(1 − x²). A stroke of a hand is displaced by its profile instead of bow and wave.
 */
export interface Stroke {
  /** Centre along the texture's u axis, in tiles. */
  u: number;
  /** Centre along the texture's v axis, in tiles. */
  v: number;
  /** The layer of the style. Strokes of the same layer keep apart, strokes of different layers cross. */
  layer: number;
  /** Whether the stroke runs along v instead of u. */
  across: boolean;
  /** The length from end to end, in tiles; 0 is a dot. */
  length: number;
  /** The tangent of the angle to the axis. */
  slope: number;
  /** Height of the arc, in tiles. */
  bow: number;
  /** Size of the S-bend, in tiles. */
  wave: number;
  /** The bends and the width of a stroke drawn by a person; undefined for a stroke of a style. */
  profile?: StrokeProfile | undefined;
  /** The width in the middle, in texels; with a profile, the width that its samples are relative to. */
  width: number;
  /** Each end narrows over this many texels, at most a quarter of the length; 0 leaves it blunt. */
  taper: number;
  /** How deeply the stroke fills the grain of the paper, from 0 (only the peaks) to 1 (all of it). */
  pressure: number;
  /** The first tone that shows the stroke; so do all darker ones. */
  tone: number;
  /** The coarsest level that shows the stroke; so do all finer ones. */
  level: number;
}

/** Sideways displacement of the centre line in tiles at x ∈ [−1, 1]. */
export const strokeOffset = (stroke: Stroke, x: number): number =>
  stroke.profile === undefined
    ? 0.5 * stroke.length * stroke.slope * x + (1 - x * x) * (stroke.bow + stroke.wave * x)
    : profileOffset(stroke, stroke.profile, x);

/**
 * The displacement of a stroke with a profile. It is separate, because the other function is called millions of times and should stay
 * short.
 */
const profileOffset = ({ length, slope }: Stroke, { offset }: StrokeProfile, x: number): number =>
  length * (0.5 * slope * x + (1 + slope * slope) * profileAt(offset, x));

/** The tangent of the centre line's angle to the axis at x, for a stroke with a profile. */
export function profileSlope(stroke: Stroke, profile: StrokeProfile, x: number): number {
  const before = profileAt(profile.offset, x - SLOPE_STEP);
  const after = profileAt(profile.offset, x + SLOPE_STEP);
  const steps = Math.min(1, x + SLOPE_STEP) - Math.max(-1, x - SLOPE_STEP);
  return stroke.slope + (2 * (1 + stroke.slope * stroke.slope) * (after - before)) / steps;
}

/** The narrowest and the widest place of a stroke for which levels nest, in texels (see `StrokeStyle.widthRange`). */
const NARROWEST = 1;
const WIDEST = 2.9;

/** The shape of a stroke drawn by a person, shared by all strokes that copy it. */
export interface StrokeProfile {
  /** Displacement of the centre line to the left-hand side, as a share of the chord. It is 0 at both ends. */
  offset: Float32Array;
  /** The width, relative to that of the stroke. */
  width: Float32Array;
  /** The shape after a half turn. */
  turned: StrokeProfile;
  /** The shape mirrored in its chord. */
  mirrored: StrokeProfile;
}

/** The value at x ∈ [−1, 1], interpolated between two samples; constant beyond. */
export function profileAt(samples: Float32Array, x: number): number {
  const place = 0.5 * (PROFILE_SAMPLES - 1) * (Math.max(-1, Math.min(1, x)) + 1);
  const first = Math.min(PROFILE_SAMPLES - 2, Math.floor(place));
  return samples[first] + (place - first) * (samples[first + 1] - samples[first]);
}

/** The width of a stroke of a hand at x, in texels. */
export const profileWidth = (profile: StrokeProfile, width: number, x: number): number =>
  Math.max(NARROWEST, Math.min(WIDEST, width * profileAt(profile.width, x)));

/** Makes a profile with its turned and mirrored forms. */
export function makeProfile(offset: Float32Array, width: Float32Array): StrokeProfile {
  const [negative, back, backWidth] = [offset.map((value) => -value), offset.toReversed(), width.toReversed()];
  const one = { offset, width } as StrokeProfile;
  const mirrored = { offset: negative, width } as StrokeProfile;
  const turned = { offset: back.map((value) => -value), width: backWidth } as StrokeProfile;
  const both = { offset: back, width: backWidth } as StrokeProfile;
  const link = (a: StrokeProfile, turnedA: StrokeProfile, mirroredA: StrokeProfile): void => {
    a.turned = turnedA;
    a.mirrored = mirroredA;
  };
  link(one, turned, mirrored);
  link(mirrored, both, one);
  link(turned, one, both);
  link(both, mirrored, turned);
  return one;
}
