/** Constants of tones and of layers of strokes, for the processor and, as defines, for the shaders. */
export const TONE_CONSTANTS = {
  /** Above the tone at which a second layer begins, the first layer still takes this share of the tone; with a pen, KEPT_BY_PEN. */
  KEPT_SHARE: 0.4,
  KEPT_BY_PEN: 0.6,
  /**
   * The tone left by the first layer at which a third layer begins to cross the second. The whole tone is then half way from `crossFrom` to
   * 1.
   */
  THIRD_FROM: 0.375,
  /**
   * Shift of each layer against the one before, in tiles or, for anchored strokes, in anchors. Arbitrary numbers that keep strokes of different
   * layers apart.
   */
  LAYER_SHIFT: [17.37, 5.71, 11.13],

  /**
   * Reflected light above the share BESIDE_FROM is multiplied by this on planes that face one side of a light, so that two walls at the
   * same angle to the light, 60° or more, differ in tone.
   */
  BESIDE_LIGHT: 1.2,
  BESIDE_FROM: 0.25,
  /** A unit vector in world space, parallel to no axis. The side of a light is perpendicular to it and to the light. */
  SIDE_AXIS: [0.36, 0.48, 0.8],

  /** Occlusion at which a hollow begins (eyelids, lips), and at which it counts as deep. */
  HOLLOW: [0.1, 0.8],
  /** From this occlusion on, directional light loses as much as light from all around. */
  CAVITY: 0.4,

  /** Cosine to the light below which shadow maps are not trusted: rounding decides there. */
  LEAST_RESPONSE: 0.05,
  /** Light weaker than this counts as unshadowed. */
  NO_LIGHT: 1e-6,

  /** Alpha of a coarser level of a map below which some of it is cut out. */
  OPAQUE_TEXEL: 0.99,
} as const;

/** Constants of soft shadows, for the processor and, as defines, for the shaders. */
export const SHADOW_CONSTANTS = {
  /** Largest number of samples of a shadow map on each side of the middle. */
  MOST_SAMPLES: 4,

  /**
   * Casters of a shadow on a ground are searched up to this many widths of the shadow map, or this share of the way to a lamp
   * (TOWARDS_LAMP).
   */
  FARTHEST_CASTER: 3,
  TOWARDS_LAMP: 0.75,
  /** Rays from a ground start this many texels above the surface, so that they do not hit it. */
  LIFT: 1.5,
  /** Least half width of the edge of a shadow on a ground, in texels. */
  THINNEST: 0.5,
  /** Directions across the light are derived from the world's up, except for lights whose cosine to it is above this. */
  OVERHEAD: 0.9,
} as const;

/** Numbers of samples of an edge. The first RIM_SAMPLES of them, on its rim, tell whether there is an edge. */
export const SHADOW_SAMPLES = { EDGE_SAMPLES: 24, RIM_SAMPLES: 6 } as const;

/** Constants of fading with distance, focus and vignette, for the processor and, as defines, for the shaders. */
export const FADING_CONSTANTS = {
  /** Exponent of the fading with distance: e^−AIR is left at the far end. */
  AIR: 3,
  /** Additional weight of outlines in front; outlines at the back lose theirs. */
  FRONT_GAIN: 0.4,
  /** Distance from the focus, in its radii, beyond which nothing is drawn. */
  FOCUS_END: 2.5,
  /** Semi-axis at which the oval of a vignette begins, in halves of the sheet. */
  VIGNETTE_START: 0.55,
  /** Amplitude by which the edge of the drawn area wavers, as a share of its radius. */
  UNEVEN: 0.12,
} as const;
