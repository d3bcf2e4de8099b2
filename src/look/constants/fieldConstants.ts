/** The numbers by which a field cuts lines out of an object, for the processor and, as defines, for the shaders. */
export const FIELD_CONSTANTS = {
  /** A light that is switched off still has a direction: its weight. */
  LEAST_WEIGHT: 1e-6,
  /** What the search for the axis of several lights starts from: every axis has a part of it. */
  FIRST_AXIS: [0.51, 0.64, 0.57],
  /** Aslant to all axes, so that no face of a box lies across it. Unit. */
  SLANT: [0.48, 0.64, 0.6],
  /** An axis with a larger part of the world's up than this is near to it: what lies across is not found by it. */
  UPRIGHT: 0.8,
  /** A light nearer to the vertical than this has no side: the sine of the angle. */
  LEAST_SINE: 1e-3,

  /**
   * Where the surface leans less than this across the gradient of the first family, sines of the angle, it has no lines left, and those that
   * cross it take its tone.
   */
  BARE_SLOPE: [0.06, 0.18],
  /** Where a function rises less than so much along the surface, new lines are born on the object too. */
  SPARSEST_SLOPE: 0.4,
  /** How far from evenly matched the two crossing families share a place: the difference of their squared sines. */
  SIDE_FADE: 0.35,
  /** The octave of the lines that lie farthest apart: as far as they like. */
  ANY_OCTAVE: 100,
} as const;
