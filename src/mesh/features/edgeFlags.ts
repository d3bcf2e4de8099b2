// Bit flags of feature edges. An edge may have several; without a kind (`DRAWN_WHOLE`) it is drawn only where the contour runs along it.

/** The edge belongs to one triangle only. */
export const BORDER = 1;
/** The edge is sharp, and part of a chain of creases that is long enough. */
export const CREASE = 2;
/** The edge lies between two groups of triangles. */
export const MATERIAL_BORDER = 4;
/** The windings of the two triangles contradict each other. */
export const CONTRARY = 8;
/** At the start of the edge a straight line ends, branches or turns. */
export const CORNER_AT_START = 16;
/** At the end of the edge a straight line ends, branches or turns. */
export const CORNER_AT_END = 32;

/** The kinds of edges that are drawn over their whole length. */
export const DRAWN_WHOLE: number = BORDER | CREASE | MATERIAL_BORDER;

/** Set for every feature edge, to distinguish it from a triangle. */
export const IS_EDGE = 64;

/** The flags that lie in the first word of an edge; the others lie in the second. */
export const LOW_FLAGS = 15;
