/** What random numbers of lines are made by, for the processor and, as defines, for the shaders: factors of words of 32 bits. */
export const HASH_FACTORS = {
  /**
   * The first 32 digits of the Thue–Morse sequence. No three digits in a row are alike, so however often a number with these digits is doubled, neither
   * it nor its double comes near a whole number.
   */
  THUE_MORSE: 0x69969669,
  /** A third: hashes by it are in turn 0, a third and two thirds, or 0, two thirds and a third, since twice a third is two thirds. */
  ONE_THIRD: 0x55555555,
  GOLDEN_RATIO: 0x9e3779b9,
  SECOND_FACTOR: 0x85ebca6b,
  THIRD_FACTOR: 0x2c1b3c6d,
} as const;

/** The number that bounds how fast functions change on the screen, for the processor and, as a define, for the shaders. */
export const SCREEN_CONSTANTS = {
  /** Surfaces whose cosine to the viewer is less than this are treated as if it were this, which bounds how close lines crowd. */
  LEAST_FACING: 0.12,
} as const;

/** The numbers that the field of lines behind a subject is ruled by, for the processor and, as defines, for the shaders. */
export const BACKGROUND_CONSTANTS = {
  /** How far apart the ends of lines lie, and over what way a line thins out, by the size of the field. */
  RAGGED: 0.4,
  THINNING: 0.5,
  /** How near to the rim of the sheet the field comes, in halves of the sheet. */
  RIM: 0.95,
} as const;
