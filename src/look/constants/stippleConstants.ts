/** The numbers that dots are placed and sized by, for the processor and, as defines, for the shaders. */
export const STIPPLE_CONSTANTS = {
  /**
   * How much the normal of the surface counts against the direction to the viewer in the choice of a plane, at least. It keeps needles from
   * lying along the surface.
   */
  LEAST_PULL: 0.5,
  /** Planes whose cosine to the best direction is less than that of the best plane by this have no dots. */
  PLANE_FADE: 0.03,
  /** Planes with a smaller share of the dots than this are left out: nobody could tell. */
  LEAST_SHARE: 0.02,
  /** A sheet is seen from behind where the cosine of its normal to the viewer is less. */
  FROM_BEHIND: -0.5,
  /** Surfaces that lean away further than this cosine are taken for ones that do not, so that dots stay round: those beyond lean. */
  LEAST_ROUND: 0.33,

  /** Dots at half tone along each side of a tile, at a sizedOnScreen of 0. */
  DOTS_PER_TILE: 64,
  /** The diameter of a dot at half tone as a share of the distance between dots: 0.8² π/4 is one half. */
  DOT_SHARE: 0.8,
  /**
   * Dots of one size that were thrown at random would be as many as −log(1 − what they cover). These lie evenly and overlap less: with this
   * power of it they keep their size in the lights, and shrink as they crowd.
   */
  CROWDING: 0.9,
  /** From this tone on down dots lie no further apart, and only grow smaller. */
  LEAST_DENSE_SHARE: 0.02,
  /** From the first tone on dots close faster than the tone deepens; from the second on nothing is left between them. */
  CLOSING: [0.7, 0.95],
  /** Where dots cover as much as this, what is left of the paper begins to fill: a speck of it would be seen. */
  FILLING: 0.97,
  /** Shift of the set along each axis, in tiles: any numbers that bring no two dots together. */
  SET_SHIFT: [3.17, 7.71, 5.39],

  /** The share of an octave in which a dot grows to its full size. */
  DOT_GROWTH: 0.35,
  /**
   * From a half on discs overlap, and more so early in an octave, when new ones lie close to others: by how much at its ends, and by how much
   * more within. Fitted to what the set of src/material/tam/stippleSet.ts covers.
   */
  OVERLAP: 0.25,
  OVERLAP_WITHIN: 2.8,
  /** The least share of the paper that is left between them in that fit. */
  LEAST_BLANK: 1e-3,
} as const;
