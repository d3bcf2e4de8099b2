/** The number that bounds how fast functions change on the screen, for the processor and, as a define, for the shaders. */
export const SCREEN_CONSTANTS = {
  /** Surfaces whose cosine to the viewer is less than this are treated as if it were this, which bounds how close lines crowd. */
  LEAST_FACING: 0.12,
} as const;
