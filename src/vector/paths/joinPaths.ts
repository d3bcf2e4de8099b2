import { type LinePath, PATH_STRIDE, pathLength, reversedPoints } from './LinePath.js';
import { PlaceGrid } from './PlaceGrid.js';

/** The least cosine between the directions of two lines that go on in each other, 45°. */
const LEAST_COSINE = Math.SQRT1_2;
/** Lines shorter than this many times the reach are no rings, though both ends lie in one place. */
const SHORTEST_RING = 10;

/** An end of an open path: its number is that of the path times two, plus one for the second end. */
interface PathEnd {
  x: number;
  y: number;
  /** Direction in which the path leaves, unit. */
  dx: number;
  dy: number;
}

/**
 * Joins lines of a pen where the end of one lies near that of another and goes on in the same direction, the nearest ends first: each join saves a
 * lift. A line whose own ends meet so becomes closed. Dashes and closed lines stay as they are.
 *
 * @param reach the greatest distance between two ends that are joined, pixels
 */
export function joinPaths(paths: readonly LinePath[], reach: number): LinePath[] {
  const partners = partnersOf(paths, reach);
  const isTaken = new Uint8Array(paths.length);
  const joined: LinePath[] = [];
  for (let first = 0; first < paths.length; first++) {
    if (isTaken[first]) continue;
    if (partners[2 * first] < 0 && partners[2 * first + 1] < 0) {
      joined.push(paths[first]);
      continue;
    }
    // Back to where the chain begins, then along it to its end.
    let from = 2 * first;
    while (partners[from] >= 0 && (partners[from] ^ 1) !== 2 * first) from = partners[from] ^ 1;
    const isClosed = partners[from] >= 0;
    const points: number[] = [];
    const begin = isClosed ? 2 * first : from;
    for (let end = begin; ; end = partners[end ^ 1]) {
      const { points: own } = paths[end >> 1];
      for (const value of end & 1 ? reversedPoints(own) : own) points.push(value);
      isTaken[end >> 1] = 1;
      if (partners[end ^ 1] < 0 || partners[end ^ 1] === begin) break;
    }
    joined.push({ points, isClosed });
  }
  return joined;
}

/** An end of a path, with the direction of a piece as long as the reach, so that a tiny last step does not decide. */
function endOf({ points }: LinePath, reach: number, side: number): PathEnd {
  const count = points.length / PATH_STRIDE;
  const at = (i: number): number => PATH_STRIDE * (side === 0 ? i : count - 1 - i);
  const [x, y] = [points[at(0)], points[at(0) + 1]];
  let [dx, dy] = [0, 0];
  for (let i = 1; i < count && dx * dx + dy * dy < reach * reach; i++)
    [dx, dy] = [x - points[at(i)], y - points[at(i) + 1]];
  const length = Math.hypot(dx, dy) || 1;
  return { x, y, dx: dx / length, dy: dy / length };
}

/** The end that each end is joined with; −1 for none. */
function partnersOf(paths: readonly LinePath[], reach: number): Int32Array {
  const ends = paths.flatMap((path) =>
    path.isClosed || path.isDash ? [null, null] : [endOf(path, reach, 0), endOf(path, reach, 1)],
  );
  const isDot = (path: LinePath): boolean => pathLength(path) < SHORTEST_RING * reach;
  const known = new PlaceGrid<number>(reach);
  const pairs: { a: number; b: number; distance: number }[] = [];
  for (const [b, end] of ends.entries()) {
    if (!end) continue;
    for (const a of known.around(end.x, end.y)) {
      const other = ends[a]!;
      const distance = Math.hypot(other.x - end.x, other.y - end.y);
      if (distance > reach || -(other.dx * end.dx + other.dy * end.dy) < LEAST_COSINE) continue;
      if (a >> 1 !== b >> 1 || !isDot(paths[a >> 1])) pairs.push({ a, b, distance });
    }
    known.add(end.x, end.y, b);
  }
  pairs.sort((one, other) => one.distance - other.distance || one.a - other.a || one.b - other.b);
  const partners = new Int32Array(ends.length).fill(-1);
  for (const { a, b } of pairs) if (partners[a] < 0 && partners[b] < 0) [partners[a], partners[b]] = [b, a];
  return partners;
}
