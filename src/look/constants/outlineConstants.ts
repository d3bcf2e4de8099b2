/** Constants of outlines, for the processor and, as defines, for the shaders (src/material/outlines/HatchingOutlineMaterial.ts). */
export const OUTLINE_CONSTANTS = {
  /** Bounds of (1 − N·L) / 2: up to the first, an outline has the weight of the lit side, from the second on that of the shade. */
  LIT: 0.15,
  SHADED: 0.85,
  /** How far the surface just inside a contour leans towards the eye: the share of that direction in its normal. */
  INSIDE: 0.5,
  /**
   * Lost edges: a contour is lost above a threshold of the N·L just inside it. The threshold falls from 1 by the first number; over a range
   * of the second it loses the share of its weight given by the third, never all, or outlines would break. Each of the two numbers is
   * followed by what is added to it where all edges are lost.
   */
  LOST_RANGE: 0.7,
  LOST_TAPER: [0.05, 0.35],
  LOST_WEIGHT: [0.53, 0.35],

  /**
   * Lift of an outline off its surface as a share of the bounding radius, against rounding and the difference between smooth normals and
   * flat triangles.
   */
  LIFT_SHARE: 0.004,
  /** Largest lift for the curvature of the surface, as a share of the bounding radius. */
  MOST_RISE: 0.11,
  /** Largest slope towards the eye of the faces beside an edge. */
  EDGE_SLOPE: 3,

  /** Depths are compared this many pixels beside an outline, where on one side nothing of its own surface lies before it. */
  BESIDE: 1,
  /** How far a surface may lie before its own outline there, as a share of the bounding radius. */
  ROUNDING: 0.0005,
  /** Pixels beside the middle of an outline between two rising sides at which its visibility is tested. */
  LOOKED_BESIDE: 2,
  /** Largest slope of the parts of a cut-out surface that have outlines. */
  CUT_SLOPE: 9,

  /** The greatest width of lines in a crowd as a share of the distance between them, of which this share of their width is taken. */
  CROWDED_SHARE: 0.35,
  LEAST_WIDTH: 0.1,

  /** Pixels beyond its side at which an outline begins to search for what lies behind it. */
  BEYOND: 1.5,
  /**
   * A surface that lies this far behind an outline, as a share of the height of the view, begins to count as paper; from the next share on
   * it does.
   */
  BEGINS_AS_PAPER: 0.25,
  IS_PAPER: 0.75,
  /** How far an accent reaches to either side, in widths of an outline. */
  ACCENT_REACH: 8,
  /**
   * Jumps of the depth behind an outline, as shares of the height of the view, from which on another outline begins to count, and counts in
   * full. Smaller differences are the outline's own surface.
   */
  LEAST_JUMP: 0.02,
  FULL_JUMP: 0.06,

  /**
   * Growth of the curvature along the surface, times the radius, at which a suggestive contour begins, and at which it has its full width.
   */
  LEAST_GROWTH: 20,
  FULL_GROWTH: 60,
  /**
   * Lean of the normal away from the viewer at which a suggestive contour begins, and at which it has its full width. Face on it would show
   * nothing.
   */
  LEAST_LEAN: 0.1,
  FULL_LEAN: 0.35,

  /**
   * Waves by which outlines stray: long ones of about a third of the radius in two directions, and shorter ones, whose phases other waves
   * bend. Arbitrary directions and phases without a pattern.
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
  /** The shares of the long and of the short waves. */
  STRAY_SHARES: [0.8, 0.2],

  /**
   * Weight of hidden outlines, whatever they weigh where they are visible. Those that weigh less than WHOLE_FROM there are hidden in part.
   */
  HIDDEN_WEIGHT: 0.5,
  WHOLE_FROM: 0.2,
  /** The share of the ink that faint lines keep. */
  FAINT: 0.4,
  /** Length of a dash and of the gap after it, in widths of an outline. */
  DASH: 3.5,
  GAP: 2,
} as const;

/** Samples to either side in the search for accents. */
export const ACCENT_STEPS = 4;
