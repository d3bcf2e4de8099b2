/** Where a path begins and ends; any unit of length. */
export interface PathEnds {
  start: readonly [number, number];
  end: readonly [number, number];
}

/** A path in the order of drawing, perhaps from its end to its start. */
export interface OrderedPath {
  path: number;
  isReversed: boolean;
}
