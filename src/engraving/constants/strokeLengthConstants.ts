/** The numbers that the lengths of strokes are found by, for the processor and, as defines, for the shaders. */
export const STROKE_LENGTH_CONSTANTS = {
  /** The last part of an octave, in which strokes give way to others half as long. */
  LENGTHS_FADE: 0.12,
  /** How evenly a line must run along two axes for both to count: the difference of the squares of its direction. */
  AXES_FADE: 0.16,
} as const;
