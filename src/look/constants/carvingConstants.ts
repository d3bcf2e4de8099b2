/** The numbers that lines are cut out of a block by, for the processor and, as defines, for the shaders. */
export const CARVING_CONSTANTS = {
  /**
   * How far a cut swells and narrows from its mean, as a share of its room, and of the mean: where white is rare, and where black is, wedges
   * are thinner, and not shorter.
   */
  SWELL: 0.42,
  SWELL_SHARE: 1.3,
  /** Where either is rarer than this, rows end, so that those that stay do not become hairs; at a quarter of it three of four have. */
  RARE: 0.24,
  /** The share of a wedge in which it widens. */
  WIDENING: 0.7,
} as const;
