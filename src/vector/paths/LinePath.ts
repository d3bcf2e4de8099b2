/** Numbers per point of a path: x, y, and half the width on its left and on its right, pixels of the picture. */
export const PATH_STRIDE = 4;

/** A polyline with widths. */
export interface LinePath {
  /** `PATH_STRIDE` numbers per point. A closed path does not repeat its first point. */
  points: readonly number[];
  isClosed: boolean;
}

/** The points of a path in reverse, with left and right exchanged. */
export function reversedPoints(points: readonly number[]): number[] {
  const reversed: number[] = [];
  for (let o = points.length - PATH_STRIDE; o >= 0; o -= PATH_STRIDE)
    reversed.push(points[o], points[o + 1], points[o + 3], points[o + 2]);
  return reversed;
}

/** Length of a path, pixels. */
export function pathLength({ points, isClosed }: LinePath): number {
  let length = 0;
  for (let i = PATH_STRIDE; i < points.length; i += PATH_STRIDE)
    length += Math.hypot(points[i] - points[i - PATH_STRIDE], points[i + 1] - points[i - PATH_STRIDE + 1]);
  const last = points.length - PATH_STRIDE;
  return isClosed ? length + Math.hypot(points[0] - points[last], points[1] - points[last + 1]) : length;
}
