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
