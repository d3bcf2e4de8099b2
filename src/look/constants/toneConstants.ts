/** The numbers that tones are made and shared out by, for the processor and, as defines, for the shaders. */
export const TONE_CONSTANTS = {
  /**
   * The share of the tone above that from which on others cross a layer which this still takes: more with a pen, whose first strokes lead.
   */
  KEPT_SHARE: 0.4,
  KEPT_BY_PEN: 0.6,
  /** The tone left by the first layer from which on a third crosses the second. The tone is then half way from where it begins to 1. */
  THIRD_FROM: 0.375,
  /** The shift of each layer against the one before, in tiles or, for `anchored`, in anchors: any numbers that bring no strokes together. */
  LAYER_SHIFT: [17.37, 5.71, 11.13],

  /**
   * A plane that faces one side of a light gets so many times what it gets of reflected light above the second share: two walls that turn from
   * the light by one angle, of 60° or more, differ in tone.
   */
  BESIDE_LIGHT: 1.2,
  BESIDE_FROM: 0.25,
  /** The side is at right angles to the light and to this direction in the world, a unit vector that is no axis of anything. */
  SIDE_AXIS: [0.36, 0.48, 0.8],

  /** The occlusion from which on a place is a hollow, which is that of eyelids and lips, and from which on it is a deep one. */
  HOLLOW: [0.1, 0.8],

  /** Where a surface hardly sees a light, whether it lies in shadow is a matter of rounding. */
  LEAST_RESPONSE: 0.05,
  /** Light that is too little for any shadow to take of it counts as arriving. */
  NO_LIGHT: 1e-6,
} as const;
