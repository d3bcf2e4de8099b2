/** The number of samples of a profile, evenly spaced in x from −1 to 1. */
export const PROFILE_SAMPLES = 33;

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
