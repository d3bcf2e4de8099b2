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
