/** Which axis of a model points up. */
export type UpAxis = 'x' | 'y' | 'z' | '-x' | '-y' | '-z';

const AXES = ['x', 'y', 'z'] as const;
/** How far a triangle may lie from the outermost plane and still belong to a flat side, as a share of the model's extent. */
const FLATNESS = 0.004;
/** A model may stand on a side of which so much is flat, and so many times as much as of any side across. */
const STAND_SHARE = 0.25;
const DISTINCTNESS = 3;
/** What would be so much lower than it is wide may as well hang on a wall: a relief or a board. */
const LOWEST = 0.4;

/**
 * Tells which axis of a model points up from the flat side that it stands on.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @returns undefined if no side is flat, or more than one pair of sides is, so that nothing can be said
 */
export function findUpAxis(positions: ArrayLike<number>, indices: ArrayLike<number> | null): UpAxis | undefined {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    low[axis] = Math.min(low[axis], positions[i]);
    high[axis] = Math.max(high[axis], positions[i]);
  }
  const size = AXES.map((_, axis) => high[axis] - low[axis]);
  const tolerance = FLATNESS * Math.max(...size);
  const corners = indices ?? { length: positions.length / 3 };
  const at = (corner: number, axis: number): number => positions[3 * (indices ? indices[corner] : corner) + axis];
  /** Area that lies on the lower and on the upper side across each axis. */
  const areas = AXES.map(() => [0, 0] as [number, number]);
  for (let corner = 0; corner + 2 < corners.length; corner += 3) {
    for (let axis = 0; axis < 3; axis++) {
      const [a, b, c] = [at(corner, axis), at(corner + 1, axis), at(corner + 2, axis)];
      const isLow = Math.max(a, b, c) - low[axis] < tolerance;
      if (!isLow && !(high[axis] - Math.min(a, b, c) < tolerance)) continue;
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const area =
        (at(corner + 1, u) - at(corner, u)) * (at(corner + 2, v) - at(corner, v)) -
        (at(corner + 2, u) - at(corner, u)) * (at(corner + 1, v) - at(corner, v));
      areas[axis][isLow ? 0 : 1] += Math.abs(area) / 2;
    }
  }
  const across = (axis: number): number => size[(axis + 1) % 3] * size[(axis + 2) % 3];
  const shares = areas.map((pair, axis) => (across(axis) > 0 ? Math.max(...pair) / across(axis) : 0));
  const best = shares.indexOf(Math.max(...shares));
  const others = shares.filter((_, axis) => axis !== best);
  const width = Math.max(size[(best + 1) % 3], size[(best + 2) % 3]);
  if (shares[best] < STAND_SHARE || shares[best] < DISTINCTNESS * Math.max(...others)) return undefined;
  if (size[best] < LOWEST * width) return undefined;
  const [below, above] = areas[best];
  // A column has two such sides: it is left the way it is.
  return above > 1.1 * below ? `-${AXES[best]}` : AXES[best];
}
