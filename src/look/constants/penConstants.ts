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
