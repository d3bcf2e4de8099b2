/** Points farther from the origin than this multiple of their size are visibly rounded in single precision. */
export const FAR = 8;

/**
 * Converts points to single precision. Points far from the origin are moved there first; models are centred later anyway.
 *
 * @param points xyz of each; NaN stays NaN
 * @param indices of the points that count; by default all
 */
export function nearFloats(points: ArrayLike<number>, indices?: ArrayLike<number>): Float32Array {
  const centre = farCentre(points, FAR, indices);
  if (!centre) return Float32Array.from(points);
  const near = new Float32Array(points.length);
  for (let i = 0; i < near.length; i++) near[i] = points[i] - centre[i % 3];
  return near;
}

/**
 * The centre of points that lie far from the origin; undefined if they do not.
 *
 * @param points xyz of each; NaN ones do not count
 * @param far this multiple of their size
 * @param indices of the points that count; by default all
 */
export function farCentre(
  points: ArrayLike<number>,
  far: number,
  indices?: ArrayLike<number>,
): readonly number[] | undefined {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const count = indices?.length ?? points.length / 3;
  for (let i = 0; i < count; i++) {
    const at = 3 * (indices ? indices[i] : i);
    const sum = points[at] + points[at + 1] + points[at + 2];
    // Skips NaN and infinite points.
    if (sum - sum !== 0) continue;
    for (let axis = 0; axis < 3; axis++) {
      if (points[at + axis] < low[axis]) low[axis] = points[at + axis];
      if (points[at + axis] > high[axis]) high[axis] = points[at + axis];
    }
  }
  const size = Math.hypot(...high.map((value, axis) => value - low[axis]));
  const centre = low.map((value, axis) => value / 2 + high[axis] / 2);
  return size > 0 && size < Infinity && Math.hypot(...centre) >= far * size ? centre : undefined;
}
