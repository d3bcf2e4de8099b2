/** How far the edge of a line fades, in pixels. */
export const FRINGE = 0.5;
