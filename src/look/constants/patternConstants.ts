/** Factors (32-bit words) of the hashes that give lines their random numbers, for the processor and, as defines, for the shaders. */
export const HASH_FACTORS = {
  /**
   * The first 32 digits of the Thue–Morse sequence. No three digits in a row are equal, so a number with these digits comes near no whole
   * number, however often it is doubled.
   */
  THUE_MORSE: 0x69969669,
  /** One third as a 32-bit fraction. Hashes by it take the values 0, 1/3 and 2/3 in turn. */
  ONE_THIRD: 0x55555555,
  GOLDEN_RATIO: 0x9e3779b9,
  SECOND_FACTOR: 0x85ebca6b,
  THIRD_FACTOR: 0x2c1b3c6d,
} as const;

/** The bound on how fast functions change on the screen, for the processor and, as a define, for the shaders. */
export const SCREEN_CONSTANTS = {
  /** Least cosine of a surface to the viewer. Surfaces at a steeper slant count as if they had it, which limits how close lines lie. */
  LEAST_FACING: 0.12,
} as const;

/** Constants of the lines behind a subject, for the processor and, as defines, for the shaders. */
export const BACKGROUND_CONSTANTS = {
  /** Spread of the ends of lines, and the length over which a line thins out, as shares of the size of the field. */
  RAGGED: 0.4,
  THINNING: 0.5,
  /** How near the field comes to the edge of the sheet, in halves of the sheet. */
  RIM: 0.95,
} as const;

/** Constants of the positions and sizes of dots, for the processor and, as defines, for the shaders. */
export const STIPPLE_CONSTANTS = {
  /**
   * Least weight of the surface normal against the direction to the viewer in the choice of a plane. It keeps needles from lying along the
   * surface.
   */
  LEAST_PULL: 0.5,
  /** A plane has no dots if its cosine to the best direction is less than that of the best plane by this. */
  PLANE_FADE: 0.03,
  /** Planes with a smaller share of the dots are left out: they would be invisible. */
  LEAST_SHARE: 0.02,
  /** A sheet is seen from behind if the cosine of its normal to the viewer is less than this. */
  FROM_BEHIND: -0.5,
  /** Dots stay round on surfaces whose cosine to the viewer is above this; beyond, they are foreshortened. */
  LEAST_ROUND: 0.33,

  /** Dots at half tone along each side of a tile, at a `screenSpaceShare` of 0. */
  DOTS_PER_TILE: 64,
  /** The diameter of a dot at half tone as a share of the distance between dots: 0.8² π/4 is one half. */
  DOT_SHARE: 0.8,
  /**
   * Dots of one size at random places would number −log(1 − coverage). These lie evenly and overlap less: with this power of that number
   * they keep their size in the lights, and shrink as they crowd.
   */
  CROWDING: 0.9,
  /** Below this tone, dots lie no farther apart and only become smaller. */
  LEAST_DENSE_SHARE: 0.02,
  /** Tones between which dots close faster than the tone deepens; from the second on no paper is left. */
  CLOSING: [0.7, 0.95],
  /** From this coverage on the remaining paper begins to fill, since single specks of it would be visible. */
  FILLING: 0.97,
  /** Shift of the set along each axis, in tiles. Arbitrary numbers that bring no two dots together. */
  SET_SHIFT: [3.17, 7.71, 5.39],

  /** The share of an octave over which a dot grows to its full size. */
  DOT_GROWTH: 0.35,
  /**
   * From a half on, discs overlap, more so early in an octave, when new ones lie close to others: the overlap at the ends of an octave, and
   * the addition within it. Fitted to the coverage of the set in src/material/tam/stippleSet.ts.
   */
  OVERLAP: 0.25,
  OVERLAP_WITHIN: 2.8,
  /** Least share of paper left in that fit. */
  LEAST_BLANK: 1e-3,
} as const;
