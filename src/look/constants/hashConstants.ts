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
