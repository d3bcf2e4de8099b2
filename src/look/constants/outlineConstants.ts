/** The numbers that outlines are drawn by, for the processor and, as defines, for the shaders (src/material/outlines/outlineConventions.ts). */
export const OUTLINE_CONSTANTS = {
  /** Up to the first of these, of (1 − N·L) / 2, an outline is as heavy as on the lit side, from the second on as in the shade. */
  LIT: 0.15,
  SHADED: 0.85,
  /** How far the surface just inside of a contour leans towards the eye: the share of that direction in its normal. */
  INSIDE: 0.5,
  /**
   * The N·L just inside above which a contour is lost falls from 1 by as much as this. Over the second of N·L it loses the third, a share of
   * its weight, and never all: where a line ended, an outline would be in pieces. Each of the two is so much where no edges are lost, and
   * grows by as much as the number after it where all are.
   */
  LOST_RANGE: 0.7,
  LOST_TAPER: [0.05, 0.35],
  LOST_WEIGHT: [0.53, 0.35],

  /** The lift as a share of the bounding radius, for rounding and for what smooth normals and flat triangles differ by. */
  LIFT_SHARE: 0.004,
  /** The most lift for the bend of the surface, as a share of the bounding radius. */
  MOST_RISE: 0.11,
  /** How steeply the faces beside an edge may rise towards the eye. */
  EDGE_SLOPE: 3,

  /** Depths are compared so many pixels beside an outline: on one of its two sides nothing of its own surface lies before it. */
  BESIDE: 1,
  /** By how much a surface may lie there before its own outline, as a share of the bounding radius, for rounding. */
  ROUNDING: 0.0005,
  /** How far beside the middle of an outline that is seen where it lies between two sides that rise from it, pixels. */
  LOOKED_BESIDE: 2,
  /** How steeply the parts of a cut-out surface may lie that have outlines. */
  CUT_SLOPE: 9,

  /** From where on beyond its side an outline looks for what lies behind it, pixels. */
  BEYOND: 1.5,
  /** A surface that lies as far behind an outline as these shares of the height of the view begins to count as paper, and does. */
  BEGINS_AS_PAPER: 0.25,
  IS_PAPER: 0.75,
  /** How far an accent reaches to either side, in widths of an outline. */
  ACCENT_REACH: 8,
  /**
   * From one step to the next, the depth behind an outline changes by these shares of the height of the view where another outline begins to
   * count, and does. What lies behind by less than the first is the outline's own surface.
   */
  LEAST_JUMP: 0.02,
  FULL_JUMP: 0.06,

  /** How fast the bend must grow along the surface, times the radius, for a suggestive contour to begin, and to be as wide as asked. */
  LEAST_GROWTH: 20,
  FULL_GROWTH: 60,
  /** Seen face on, such an outline says nothing: how far the normal must lean away for one to begin, and to be as wide as asked. */
  LEAST_LEAN: 0.1,
  FULL_LEAN: 0.35,

  /**
   * The waves by which outlines stray: of about a third of the radius in two directions, and shorter ones, whose phases others bend. The
   * numbers mean nothing: they are directions and phases without a pattern.
   */
  STRAY_ACROSS: [11.3, 7.1, -5.9],
  ACROSS_BENT: [-4.3, 6.7, 9.1],
  ACROSS_BEND: 1.7,
  STRAY_UP: [-6.1, 9.7, 12.7],
  UP_BENT: [8.9, -3.7, 5.3],
  UP_BEND: 1.3,
  UP_PHASE: 2,
  STRAY_FINELY: [23, -19, 17],
  FINE_PHASE: 4,
  /** The share of the long waves, and of the short ones. */
  STRAY_SHARES: [0.8, 0.2],

  /** The weight of what is hidden, whatever it would weigh where it is seen; what weighs less than the second there is hidden in part. */
  HIDDEN_WEIGHT: 0.5,
  WHOLE_FROM: 0.2,
  /** The share of the ink that is left of faint lines. */
  FAINT: 0.4,
  /** Lengths of a dash and of the gap after it, in widths of an outline. */
  DASH: 3.5,
  GAP: 2,
} as const;

/** In how many steps an outline looks for accents, to either side. */
export const ACCENT_STEPS = 4;
