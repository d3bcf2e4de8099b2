/** The numbers by which a drawing loses weight, for the processor and, as defines, for the shaders. */
export const EMPHASIS_CONSTANTS = {
  /** The air takes the same share of what is left with every stretch of the way: e to this power of it all the way. */
  AIR: 3,
  /** How much more weight than usual outlines have in front, where the back has none. */
  FRONT_GAIN: 0.4,
  /** Where nothing is left beyond the focus, in its radii. */
  FOCUS_END: 2.5,
  /** Where the oval of a vignette begins, in halves of the sheet. */
  VIGNETTE_START: 0.55,
  /** How far the edge of what is left out wavers, as a share of its radius. */
  UNEVEN: 0.12,
} as const;
