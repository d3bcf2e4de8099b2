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
