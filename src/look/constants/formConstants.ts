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
