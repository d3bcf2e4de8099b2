/** The lowest and highest value of each coordinate. Without points, `low` is Infinity and `high` is -Infinity. */
export interface Bounds {
  low: [x: number, y: number, z: number];
  high: [x: number, y: number, z: number];
}

/** The bounds of points, given as xyz. */
export function boundsOf(positions: ArrayLike<number>): Bounds {
  const low: Bounds['low'] = [Infinity, Infinity, Infinity];
  const high: Bounds['high'] = [-Infinity, -Infinity, -Infinity];
  for (let axis = 0; axis < 3; axis++) {
    let least = Infinity;
    let largest = -Infinity;
    for (let i = axis; i < positions.length; i += 3) {
      const value = positions[i];
      if (value < least) least = value;
      if (value > largest) largest = value;
    }
    low[axis] = least;
    high[axis] = largest;
  }
  return { low, high };
}
