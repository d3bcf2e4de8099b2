/** What a feature edge is, as bits. An edge may be several things; one without a kind is drawn where the contour runs along it. */
export const BORDER = 1;
/** Sharp, and part of creases that are long together. */
export const CREASE = 2;
/** Between two groups of triangles. */
export const MATERIAL_BORDER = 4;
/** The windings of its two triangles contradict each other. */
export const CONTRARY = 8;
/** A straight run ends, branches or turns at the edge's start, or its end. */
export const CORNER_AT_START = 16;
export const CORNER_AT_END = 32;

/** All kinds that are drawn whole. */
export const DRAWN_WHOLE: number = BORDER | CREASE | MATERIAL_BORDER;

/** Set on every feature edge, to tell it from a triangle. */
export const IS_EDGE = 64;

/** The flags that lie in the first word of an edge; the others lie in the second. */
export const LOW_FLAGS = 15;
