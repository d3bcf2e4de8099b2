/** The numbers that engraved lines of any field are laid by, for the processor and, as defines, for the shaders. */
export const LINE_CONSTANTS = {
  /** Lengths that are measured on the object are given in parts of a tile: so many. */
  PARTS_OF_TILE: 256,
  /** Families that cross the first have no lines where their tone is no more than this: nobody could tell. */
  LEAST_TONE: 1e-4,
  /** Lines are spaced by the smooth normal, and at most so many times as far apart or as close as that asks on the flat triangle. */
  MOST_OFF_TRIANGLE: 1.5,
  /** A triangle along which a function hardly changes shows at least this share of the change by the smooth normal: lines cannot be any closer. */
  LEAST_OF_SMOOTH: 0.0625,
} as const;

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

/** The numbers that lines which follow the form are drawn by, for the processor and, as defines, for the shaders. */
export const FORM_CONSTANTS = {
  /**
   * The octaves of the powers of two by which the function, and the one that crosses it, change across the seams of the bake
   * (src/mesh/form/phase/lastLevel.ts): lines that lie farther apart would not run on.
   */
  COARSEST_OCTAVES: [2, 1],
  /** How much the widths of lines differ, slowly along each of them: a number of a line would change across a seam. */
  WIDTH_WAVE: 0.25,
} as const;

/** The numbers that the lengths of strokes are found by, for the processor and, as defines, for the shaders. */
export const STROKE_LENGTH_CONSTANTS = {
  /** The last part of an octave, in which strokes give way to others half as long. */
  LENGTHS_FADE: 0.12,
  /** How evenly a line must run along two axes for both to count: the difference of the squares of its direction. */
  AXES_FADE: 0.16,
  /**
   * Lines of a form differ in full where they lie so many octaves closer than the seams repeat their numbers, and at least by this share of that:
   * of few lines that repeat, the same ones would show again and again.
   */
  DIFFERING_OCTAVES: 5,
  LEAST_DIFFERING: 0.01,
} as const;

/** The numbers by which a hand is unsteady, for the processor and, as defines, for the shaders. */
export const HAND_CONSTANTS = {
  /** Units of the slow waves of a hand to a tile. */
  HAND_WAVES: 3.5,
  /** Other waves bend the slow ones: how far, how many there are to a unit and their phases. The numbers are without a pattern. */
  BENT_BY: 0.7,
  BENDS: 0.54,
  BEND_PHASES: [0.1, 0.67, 1.4],
  /** How many slow waves there are to a unit, and their phases. */
  SLOW_WAVES: 0.73,
  WAVE_PHASES: [0.35, 1.18, 1.66],

  /** How far lines stray, in tiles. */
  STRAY: 0.012,
  /** How much the pressure of a hand changes at most, and how much the widths of lines differ. */
  PRESSURE: 0.3,
  WIDTHS: 0.5,
} as const;

/** The numbers that a pen draws lines in strokes by, for the processor and, as defines, for the shaders. */
export const PEN_CONSTANTS = {
  /** The tone from which on all strokes are there, and over how much of the tone each grows to its width and length. */
  ALL_FROM: 0.15,
  STROKE_GROWTH: 0.05,
  /** How much shorter a stroke is that begins to grow, and the same of its ink, whose ends are thin, both as shares of its length. */
  SHORTENING: 0.35,
  SHORTENING_OF_INK: 0.58,
  /** The widest stroke of a light tone, as a share of the room of a line: a nib draws no heavier where strokes are few. */
  NIB: 0.6,
  /** Over how much of the share of strokes that are there each of those between older lines grows to its width. */
  BIRTH: 0.08,
  /** The tone from which on strokes follow each other without gaps, and the most that one begins late, as a share of the mean length. */
  CLOSED_FROM: 0.8,
  LATENESS: 0.4,
  /** From which of its bits on the hash of a stroke that it has by chance decides how late it begins. */
  LATE_HASH: 16,
  /** The longest gap between two strokes and the part over which both ends of one narrow, as shares of its length; both close with the tone. */
  STROKE_GAP: 0.3,
  TAPER: 0.9,
  /** How far strokes lean and bend, in distances between lines, and how much their widths differ. */
  LEANING: 0.22,
  BENDING: 0.16,
  WIDTH_SPREAD: 0.5,
  /** From which of its bits on the even hash of a stroke decides on the gap before it, on its birth and on its width. */
  GAP_HASH: 64,
  BIRTH_HASH: 512,
  WIDTH_HASH: 4096,
  /** From which of its bits on the hash of a line decides when it goes over to another axis, and over how large a part of the way it does so. */
  AXIS_HASH: 8,
  AXIS_TURN: 0.2,
} as const;

/** The numbers that lines are cut out of a block by, for the processor and, as defines, for the shaders. */
export const CARVING_CONSTANTS = {
  /**
   * How far a cut swells and narrows from its mean, as a share of its room, and of the mean: where white is rare, and where black is, wedges
   * are thinner, and not shorter.
   */
  SWELL: 0.42,
  SWELL_SHARE: 1.3,
  /** Where either is rarer than this, rows end, so that those that stay do not become hairs; at a quarter of it three of four have. */
  RARE: 0.24,
  /** The share of a wedge in which it widens. */
  WIDENING: 0.7,
} as const;

/** The numbers by which lines end where a shadow on a ground dissolves, for the processor and, as defines, for the shaders. */
export const GROUND_CONSTANTS = {
  /**
   * Where a shadow dissolves its lines end one by one: of a line whose turn it is at a share of all turns, a part of its width is gone that is
   * so many times that share, times what is dissolved over what is left.
   */
  ENDING: 0.4,
  /** No more than that: half of all lines end so, and the others thin out together, or one would stand alone at the end. */
  MOST_ENDING: 2,
  /** What is left counts as at least this. */
  LEAST_LEFT: 1e-3,
} as const;
