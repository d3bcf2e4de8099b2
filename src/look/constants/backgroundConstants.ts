/** The numbers that the field of lines behind a subject is ruled by, for the processor and, as defines, for the shaders. */
export const BACKGROUND_CONSTANTS = {
  /** How far apart the ends of lines lie, and over what way a line thins out, by the size of the field. */
  RAGGED: 0.4,
  THINNING: 0.5,
  /** How near to the rim of the sheet the field comes, in halves of the sheet. */
  RIM: 0.95,
} as const;
