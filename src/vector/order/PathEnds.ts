/** Start and end of a path; any unit of length. */
export interface PathEnds {
  start: readonly [number, number];
  end: readonly [number, number];
}

/** A path in the order of drawing, perhaps reversed. */
export interface OrderedPath {
  path: number;
  isReversed: boolean;
}
