/** Factors (32-bit words) of the hashes that give lines their random numbers, for the processor and, as defines, for the shaders. */
export const HASH_FACTORS = {
  /**
   * The first 32 digits of the Thue–Morse sequence. No three digits in a row are equal, so a number with these digits comes near no whole
   * number, however often it is doubled.
   */
  THUE_MORSE: 0x69969669,
  /** One third as a 32-bit fraction. Hashes by it take the values 0, 1/3 and 2/3 in turn. */
  ONE_THIRD: 0x55555555,
  GOLDEN_RATIO: 0x9e3779b9,
  SECOND_FACTOR: 0x85ebca6b,
  THIRD_FACTOR: 0x2c1b3c6d,
} as const;

/** The bound on how fast functions change on the screen, for the processor and, as a define, for the shaders. */
export const SCREEN_CONSTANTS = {
  /** Least cosine of a surface to the viewer. Surfaces at a steeper slant count as if they had it, which limits how close lines lie. */
  LEAST_FACING: 0.12,
} as const;

/** Constants of the lines behind a subject, for the processor and, as defines, for the shaders. */
export const BACKGROUND_CONSTANTS = {
  /** Spread of the ends of lines, and the length over which a line thins out, as shares of the size of the field. */
  RAGGED: 0.4,
  THINNING: 0.5,
  /** How near the field comes to the edge of the sheet, in halves of the sheet. */
  RIM: 0.95,
} as const;
