import { disjointSets, join, rootOf } from '../../../mesh/disjointSets.js';
import { boundsOf } from './PlainMesh.js';

/** The maximum height of a foot's sole above the lowest point, as a share of the model's extent. */
const CONTACT = 0.005;
/** The greatest number of feet, of several pieces of furniture together. */
const MOST = 16;
/** The largest foot, as a share of the length and of the width of the model. */
const LARGEST = 0.2;
/** The least distance between two of the feet, as a share of the length and of the width of the model. */
const APART = 0.4;
/** The maximum distance of two feet from one line across the model, as a share of its extent. */
const SKEW = 0.05;

/**
 * Whether a model stands on small feet at the corners of rectangles, as tables, chairs and shelves do.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param axis the vertical axis: 0, 1 or 2
 * @param end the end of that axis at which the feet are
 */
export function standsOnFeet(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  axis: number,
  end: 'low' | 'high',
): boolean {
  const { low, high } = boundsOf(positions);
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const size = high.map((value, i) => value - low[i]);
  const extent = Math.max(...size);
  if (!(size[u] > 0 && size[v] > 0)) return false;
  const feet = contactsOf(positions, indices, (point) => {
    const height = end === 'low' ? positions[point + axis] - low[axis] : high[axis] - positions[point + axis];
    return height <= CONTACT * extent;
  }).map((points) => boxOf(positions, points, u, v));
  if (feet.length < 4 || feet.length > MOST) return false;
  if (feet.some(({ width, depth }) => width > LARGEST * size[u] || depth > LARGEST * size[v])) return false;
  const inLine = (one: number, other: number): boolean => Math.abs(one - other) <= SKEW * extent;
  const apart = (one: number, other: number, axis: number): boolean => Math.abs(one - other) > APART * size[axis];
  return (
    feet.every(
      (foot) =>
        feet.some((other) => other !== foot && inLine(foot.x, other.x) && !inLine(foot.y, other.y)) &&
        feet.some((other) => other !== foot && inLine(foot.y, other.y) && !inLine(foot.x, other.x)),
    ) &&
    feet.some((foot) => apart(foot.x, feet[0].x, u)) &&
    feet.some((foot) => apart(foot.y, feet[0].y, v))
  );
}

/** The vertices that touch the ground, in sets that edges on the ground connect. Vertices at one place are one. */
function contactsOf(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  touches: (point: number) => boolean,
): number[][] {
  const places = new Map<string, number>();
  const points: number[] = [];
  const placeOf = new Map<number, number>();
  const count = indices?.length ?? positions.length / 3;
  const corner = (i: number): number => 3 * (indices ? indices[i] : i);
  for (let i = 0; i < count; i++) {
    const point = corner(i);
    if (!touches(point) || placeOf.has(point)) continue;
    const key = `${positions[point]} ${positions[point + 1]} ${positions[point + 2]}`;
    const place = places.get(key) ?? points.length;
    if (place === points.length) points.push(point);
    places.set(key, place);
    placeOf.set(point, place);
  }
  const sets = disjointSets(points.length);
  for (let i = 0; i + 2 < count; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => placeOf.get(corner(i + k)));
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ])
      if (from !== undefined && to !== undefined) join(sets, from, to);
  }
  const contacts = new Map<number, number[]>();
  for (const [place, point] of points.entries()) {
    const root = rootOf(sets, place);
    contacts.set(root, [...(contacts.get(root) ?? []), point]);
  }
  return [...contacts.values()];
}

/** The middle and the size of a set of points on the ground. */
interface Contact {
  x: number;
  y: number;
  width: number;
  depth: number;
}

function boxOf(positions: ArrayLike<number>, points: readonly number[], u: number, v: number): Contact {
  const range = (axis: number): [low: number, size: number] => {
    const values = points.map((point) => positions[point + axis]);
    const lowest = values.reduce((a, b) => Math.min(a, b));
    return [lowest, values.reduce((a, b) => Math.max(a, b)) - lowest];
  };
  const [[left, width], [near, depth]] = [range(u), range(v)];
  return { x: left + width / 2, y: near + depth / 2, width, depth };
}
