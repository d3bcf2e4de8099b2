/** A polygon with two notches, whose area is 18. */
export const COMB: (readonly [number, number])[] = [
  [0, 0],
  [6, 0],
  [6, 4],
  [5, 4],
  [5, 1],
  [4, 1],
  [4, 4],
  [2, 4],
  [2, 1],
  [1, 1],
  [1, 4],
  [0, 4],
];
