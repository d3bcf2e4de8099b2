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
  const count = indices?.length ?? positions.length / 3;
  const sides = outerSides(positions, low, high, tolerance);
  /** Area that lies on the lower and on the upper side across each axis. */
  const areas = AXES.map(() => [0, 0] as [number, number]);
  for (let corner = 0; corner + 2 < count; corner += 3) {
    const [a, b, c] = indices
      ? [indices[corner], indices[corner + 1], indices[corner + 2]]
      : [corner, corner + 1, corner + 2];
    const side = sides[a] & sides[b] & sides[c];
    if (side === 0) continue;
    for (let axis = 0; axis < 3; axis++) {
      const ofAxis = (side >> (2 * axis)) & 3;
      if (ofAxis === 0) continue;
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const from = (vertex: number, across: number): number =>
        positions[3 * vertex + across] - positions[3 * a + across];
      const area = from(b, u) * from(c, v) - from(c, u) * from(b, v);
      areas[axis][ofAxis & 1 ? 0 : 1] += Math.abs(area) / 2;
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

/** Of each vertex, which sides of the model it lies on: two bits an axis, 1 for the lower side and 2 for the upper one. */
function outerSides(
  positions: ArrayLike<number>,
  low: readonly number[],
  high: readonly number[],
  tolerance: number,
): Uint8Array {
  const sides = new Uint8Array(positions.length / 3);
  for (let vertex = 0; vertex < sides.length; vertex++) {
    for (let axis = 0; axis < 3; axis++) {
      const at = positions[3 * vertex + axis];
      if (at - low[axis] < tolerance) sides[vertex] |= 1 << (2 * axis);
      if (high[axis] - at < tolerance) sides[vertex] |= 2 << (2 * axis);
    }
  }
  return sides;
}
