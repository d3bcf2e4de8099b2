/** Texels per side of the coarsest level of a map. On a smaller level, strokes would be as wide as long. */
export const COARSEST_SIZE = 16;
