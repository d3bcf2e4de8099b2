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
  /** From this occlusion on, directional light loses as much as light from all around. */
  CAVITY: 0.4,

  /** Where a surface hardly sees a light, whether it lies in shadow is a matter of rounding. */
  LEAST_RESPONSE: 0.05,
  /** Light that is too little for any shadow to take of it counts as arriving. */
  NO_LIGHT: 1e-6,
} as const;

/** The numbers by which shadows soften and dissolve, for the processor and, as defines, for the shaders. */
export const SHADOW_CONSTANTS = {
  /** A map is softened by at most so many samples on each side of the middle. */
  MOST_SAMPLES: 4,

  /** What casts a shadow on a ground is looked for up to so many widths of what the map covers, and so much of the way to a lamp. */
  FARTHEST_CASTER: 3,
  TOWARDS_LAMP: 0.75,
  /** On a ground rays start so many texels above the surface, which does not meet itself then. */
  LIFT: 1.5,
  /** The least width of the edge of a shadow on a ground, texels on either side. */
  THINNEST: 0.5,
  /** Directions across the light are taken from the world's up, unless the light comes from there: the cosine. */
  OVERHEAD: 0.9,
} as const;

/** Samples of an edge; after those of its rim it is known whether there is one. */
export const SHADOW_SAMPLES = { EDGE_SAMPLES: 24, RIM_SAMPLES: 6 } as const;

/** The numbers by which a drawing loses weight, for the processor and, as defines, for the shaders. */
export const EMPHASIS_CONSTANTS = {
  /** The air takes the same share of what is left with every stretch of the way: e to this power of it all the way. */
  AIR: 3,
  /** How much more weight than usual outlines have in front, where the back has none. */
  FRONT_GAIN: 0.4,
  /** Where nothing is left beyond the focus, in its radii. */
  FOCUS_END: 2.5,
  /** Where the oval of a vignette begins, in halves of the sheet. */
  VIGNETTE_START: 0.55,
  /** How far the edge of what is left out wavers, as a share of its radius. */
  UNEVEN: 0.12,
} as const;
