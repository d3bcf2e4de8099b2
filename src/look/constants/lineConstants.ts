/** Constants of engraved lines of any field, for the processor and, as defines, for the shaders. */
export const LINE_CONSTANTS = {
  /** Lengths on the object are given in 1/256 of a tile. */
  PARTS_OF_TILE: 256,
  /** Crossing families of a tone up to this are left out: they would be invisible. */
  LEAST_TONE: 1e-4,
  /** Lines are spaced by the smooth normal. Their distance differs from that on the flat triangle by at most this factor. */
  MOST_OFF_TRIANGLE: 1.5,
  /**
   * On a triangle along which a function hardly changes, at least this share of the change by the smooth normal is used, which limits how
   * close lines lie.
   */
  LEAST_OF_SMOOTH: 0.0625,
} as const;

/** Constants of the fields that cut lines out of an object, for the processor and, as defines, for the shaders. */
export const FIELD_CONSTANTS = {
  /** Weight of a light that is switched off, so that its direction remains. */
  LEAST_WEIGHT: 1e-6,
  /** Start of the search for the axis of several lights. It has a component along every axis. */
  FIRST_AXIS: [0.51, 0.64, 0.57],
  /** Unit vector that is parallel to no axis, so that no face of a box lies across it. */
  SLANT: [0.48, 0.64, 0.6],
  /** An axis whose component along the world's up is larger counts as vertical, so another axis is used to find what lies across it. */
  UPRIGHT: 0.8,
  /** Sine of the angle to the vertical below which a light has no side. */
  LEAST_SINE: 1e-3,

  /**
   * Sines of the angle between the surface and the level sets of the first family: below the first, that family has no lines, and the
   * crossing family takes its tone; from the second on it is whole.
   */
  BARE_SLOPE: [0.06, 0.18],
  /** Where a function rises by less than this along the surface, new lines are inserted on the object too. */
  SPARSEST_SLOPE: 0.4,
  /** Range over which two crossing families share a place, as a difference of their squared sines. */
  SIDE_FADE: 0.35,
  /** Octave of lines whose distance is not limited. */
  ANY_OCTAVE: 100,
} as const;

/** Constants of lines that follow the form, for the processor and, as defines, for the shaders. */
export const FORM_CONSTANTS = {
  /**
   * log₂ of the multiples by which φ and φ₂ jump across the seams of the bake (src/mesh/form/phase/solvePhase.ts). Lines farther apart than
   * these octaves would break at a seam.
   */
  COARSEST_OCTAVES: [2, 1],
  /** Amplitude of the slow variation of width along each line. A random number per line would change across a seam. */
  WIDTH_WAVE: 0.25,
} as const;

/** Constants of the lengths of strokes, for the processor and, as defines, for the shaders. */
export const STROKE_LENGTH_CONSTANTS = {
  /** Last part of an octave, in which strokes give way to strokes of half the length. */
  LENGTHS_FADE: 0.12,
  /** Range in which two axes count for a line, as a difference of the squares of its direction. */
  AXES_FADE: 0.16,
  /**
   * Lines of a form differ in full where they lie this many octaves closer than the numbers of the seams repeat, and by at least
   * LEAST_DIFFERING of that: of few lines that repeat, the repetition would be visible.
   */
  DIFFERING_OCTAVES: 5,
  LEAST_DIFFERING: 0.01,
} as const;

/** Constants of an unsteady hand, for the processor and, as defines, for the shaders. */
export const HAND_CONSTANTS = {
  /** Units of the slow waves of a hand per tile. */
  HAND_WAVES: 3.5,
  /** Amplitude, frequency per unit and phases of the waves that bend the slow ones. Arbitrary numbers without a pattern. */
  BENT_BY: 0.7,
  BENDS: 0.54,
  BEND_PHASES: [0.1, 0.67, 1.4],
  /** Frequency per unit and phases of the slow waves. */
  SLOW_WAVES: 0.73,
  WAVE_PHASES: [0.35, 1.18, 1.66],

  /** How far lines stray, in tiles. */
  STRAY: 0.012,
  /** Largest change of the pressure, and the spread of the widths of lines. */
  PRESSURE: 0.3,
  WIDTHS: 0.5,
} as const;

/** Constants of pen strokes, for the processor and, as defines, for the shaders. */
export const PEN_CONSTANTS = {
  /** Tone from which on all strokes are there, and the range of tone over which a stroke grows to its width and length. */
  ALL_FROM: 0.15,
  STROKE_GROWTH: 0.05,
  /** How much shorter a stroke is when it begins to grow, and how much shorter its ink is, whose ends are thin; shares of its length. */
  SHORTENING: 0.35,
  SHORTENING_OF_INK: 0.58,
  /** Widest stroke of a light tone, as a share of the distance between lines: a nib does not draw heavier where strokes are few. */
  NIB: 0.6,
  /** Range of the share of visible strokes over which a stroke between older ones grows to its width. */
  BIRTH: 0.08,
  /** Tone from which on strokes follow each other without gaps, and the largest delay of a start, as a share of the mean length. */
  CLOSED_FROM: 0.8,
  LATENESS: 0.4,
  /** First bit, as a power of two, of the random hash of a stroke that decides how late it begins. */
  LATE_HASH: 16,
  /**
   * Longest gap between two strokes, and the part of a stroke over which its two ends narrow, as shares of its length. Both shrink with the
   * tone.
   */
  STROKE_GAP: 0.3,
  TAPER: 0.9,
  /** How far strokes lean and bend, in distances between lines, and the spread of their widths. */
  LEANING: 0.22,
  BENDING: 0.16,
  WIDTH_SPREAD: 0.5,
  /** First bits, as powers of two, of the even hash of a stroke that decide on the gap before it, on its birth and on its width. */
  GAP_HASH: 64,
  BIRTH_HASH: 512,
  WIDTH_HASH: 4096,
  /**
   * First bit, as a power of two, of the hash of a line that decides where it changes to another axis, and the part of the way over which
   * it does.
   */
  AXIS_HASH: 8,
  AXIS_TURN: 0.2,
} as const;

/** Constants of woodcut lines, for the processor and, as defines, for the shaders. */
export const CARVING_CONSTANTS = {
  /**
   * How far a cut swells and narrows from its mean width, as a share of the room of a line, and of the mean. Where white or black is rare,
   * wedges are thinner, not shorter.
   */
  SWELL: 0.42,
  SWELL_SHARE: 1.3,
  /**
   * Where white or black is rarer than this, rows end, so that the rest do not become hairlines; at a quarter of it three of four have
   * ended.
   */
  RARE: 0.24,
  /** The share of a wedge over which it widens. */
  WIDENING: 0.7,
} as const;

/** Constants of lines that end where the shadow on a ground dissolves, for the processor and, as defines, for the shaders. */
export const GROUND_CONSTANTS = {
  /**
   * Lines end one by one where a shadow dissolves. A line of rank r in [0, 1] loses the part ENDING · r · dissolved / left of its width.
   */
  ENDING: 0.4,
  /**
   * Upper bound of dissolved / left: half of the lines end that way, and the rest thin out together, so that none stands alone at the end.
   */
  MOST_ENDING: 2,
  /** Lower bound of the part of the shadow that is left. */
  LEAST_LEFT: 1e-3,
} as const;
