/** Texels per side of the coarsest level of a map: on fewer, strokes are as long as they are wide. */
export const COARSEST_SIZE = 16;
