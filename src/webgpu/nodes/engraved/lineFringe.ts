/** Width over which the edge of a line fades, pixels. */
export const FRINGE = 0.5;
