/** The least and the largest of each coordinate. Infinite, the wrong way round, where there are no points. */
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
