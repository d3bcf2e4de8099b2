/** The numbers that engraved lines of any field are laid by, for the processor and, as defines, for the shaders. */
export const LINE_CONSTANTS = {
  /** Lengths that are measured on the object are given in parts of a tile: so many. */
  PARTS_OF_TILE: 256,
  /** Families that cross the first have no lines where their tone is no more than this: nobody could tell. */
  LEAST_TONE: 1e-4,
} as const;
