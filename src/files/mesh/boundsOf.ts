/** The least and the largest value of each coordinate. Without points, `low` is Infinity and `high` is -Infinity. */
export interface Bounds {
  low: [x: number, y: number, z: number];
  high: [x: number, y: number, z: number];
}

/** The bounds of points, given as xyz. */
export function boundsOf(positions: ArrayLike<number>): Bounds {
  const low: Bounds['low'] = [Infinity, Infinity, Infinity];
  const high: Bounds['high'] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    const value = positions[i];
    if (value < low[axis]) low[axis] = value;
    if (value > high[axis]) high[axis] = value;
  }
  return { low, high };
}
