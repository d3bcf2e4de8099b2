/** The numbers by which lines end where a shadow on a ground dissolves, for the processor and, as defines, for the shaders. */
export const GROUND_CONSTANTS = {
  /** Where a shadow dissolves its lines end one by one: the first of them so early, as a share of what is left of it. */
  FIRST_END: 0.4,
  /** What is left counts as at least this. */
  LEAST_LEFT: 1e-3,
} as const;
