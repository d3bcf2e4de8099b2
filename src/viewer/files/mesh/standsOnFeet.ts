import { disjointSets, join, rootOf } from '../../../mesh/disjointSets.js';

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
 * @param sides for each vertex the bits of the model's sides that it lies on
 * @param side the bit of the side that is looked at
 * @param axis the axis across that side: 0, 1 or 2
 * @param size of the model along each axis
 */
export function standsOnFeet(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  sides: Uint8Array,
  side: number,
  axis: number,
  size: readonly number[],
): boolean {
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  if (!(size[u] > 0 && size[v] > 0)) return false;
  const contacts = contactsOf(positions, indices, (vertex) => (sides[vertex] & side) !== 0);
  if (contacts.length < 4 || contacts.length > MOST) return false;
  const feet = contacts.map((points) => boxOf(positions, points, u, v));
  if (feet.some(({ width, depth }) => width > LARGEST * size[u] || depth > LARGEST * size[v])) return false;
  const skew = SKEW * Math.max(...size);
  const inLine = (one: number, other: number): boolean => Math.abs(one - other) <= skew;
  const apart = (one: number, other: number, across: number): boolean => Math.abs(one - other) > APART * size[across];
  return (
    feet.every(
      (foot) =>
        feet.some((other) => inLine(foot.x, other.x) && !inLine(foot.y, other.y)) &&
        feet.some((other) => inLine(foot.y, other.y) && !inLine(foot.x, other.x)),
    ) &&
    feet.some((foot) => apart(foot.x, feet[0].x, u)) &&
    feet.some((foot) => apart(foot.y, feet[0].y, v))
  );
}

/** The vertices that touch the ground, in sets that edges on the ground connect. Vertices at one place are one. */
function contactsOf(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  touches: (vertex: number) => boolean,
): number[][] {
  const points: number[] = [];
  const places = new Map<string, number>();
  const placeOf = new Map<number, number>();
  const place = (vertex: number): number => {
    const known = placeOf.get(vertex);
    if (known !== undefined) return known;
    const key = `${positions[3 * vertex]} ${positions[3 * vertex + 1]} ${positions[3 * vertex + 2]}`;
    const found = places.get(key) ?? points.push(3 * vertex) - 1;
    places.set(key, found);
    placeOf.set(vertex, found);
    return found;
  };
  /** Places at the two ends of edges. */
  const edges: number[] = [];
  const count = indices?.length ?? positions.length / 3;
  for (let i = 0; i + 2 < count; i += 3) {
    const a = indices ? indices[i] : i;
    const b = indices ? indices[i + 1] : i + 1;
    const c = indices ? indices[i + 2] : i + 2;
    const isA = touches(a);
    const isB = touches(b);
    const isC = touches(c);
    // Most triangles touch nothing.
    if (!isA && !isB && !isC) continue;
    const first = place(isA ? a : isB ? b : c);
    if (isB) edges.push(first, place(b));
    if (isC) edges.push(first, place(c));
  }
  const sets = disjointSets(points.length);
  for (let i = 0; i < edges.length; i += 2) join(sets, edges[i], edges[i + 1]);
  const contacts = new Map<number, number[]>();
  for (const [number, point] of points.entries()) {
    const root = rootOf(sets, number);
    const known = contacts.get(root);
    if (known) known.push(point);
    else contacts.set(root, [point]);
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
