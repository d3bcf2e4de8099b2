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
