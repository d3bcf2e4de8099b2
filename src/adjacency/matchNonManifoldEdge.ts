import { nextCorner, previousCorner } from '../mesh/corners.js';
import { EdgeAxes } from './EdgeAxes.js';

/** A half-edge of a non-manifold edge. */
interface Fin {
  corner: number;
  isForward: boolean;
  /** Angle of the triangle's normal about the edge, up to a constant, in [0, 2π). */
  angle: number;
  /** Offset in `positions` of the vertex opposite to the edge. */
  opposite: number;
}

/** Two fins side by side, one forward and one backward, that may become twins. */
interface Candidate {
  gap: number;
  left: number;
  right: number;
}

const TWO_PI = 2 * Math.PI;

/**
 * Makes twins among the half-edges `corners` of one undirected edge that more than two triangles share: a forward and a
 * backward one each time, closest normals first (the rule of DirectXMesh), until one kind has run out. The others keep
 * no twin. Returns the number of steps taken.
 *
 * All normals are perpendicular to the edge, so each is an angle about it, and the closest pair are always neighbours in
 * the order of angles. That makes O(n log n) of what compares all pairs otherwise. Angles and tie-breaks come from
 * positions alone: the order of triangles and vertices in the mesh does not matter. Only copies of one triangle, which
 * nothing else can tell apart, are ordered by corner.
 */
export function matchNonManifoldEdge(
  corners: readonly number[],
  positions: Float32Array,
  canonicalCorners: Uint32Array,
  twins: Int32Array,
): number {
  const fins = sortedFins(corners, positions, canonicalCorners);
  const count = fins.length;
  let steps = count;
  const before = fins.map((_, i) => (i + count - 1) % count);
  const after = fins.map((_, i) => (i + 1) % count);
  const isMatched = new Uint8Array(count);
  const heap: Candidate[] = [];

  const consider = (left: number, right: number): void => {
    if (left === right || fins[left].isForward === fins[right].isForward) return;
    const gap = (fins[right].angle - fins[left].angle + TWO_PI) % TWO_PI;
    steps += push(heap, { gap, left, right });
  };
  for (let i = 0; i < count; i++) consider(i, after[i]);

  while (heap.length > 0) {
    const { left, right } = heap[0];
    steps += pop(heap);
    if (isMatched[left] || isMatched[right]) continue;
    isMatched[left] = 1;
    isMatched[right] = 1;
    twins[fins[left].corner] = fins[right].corner;
    twins[fins[right].corner] = fins[left].corner;
    const outerLeft = before[left];
    const outerRight = after[right];
    if (isMatched[outerLeft] || isMatched[outerRight]) continue;
    after[outerLeft] = outerRight;
    before[outerRight] = outerLeft;
    consider(outerLeft, outerRight);
  }
  return steps;
}

/** The half-edges as fins, in the order of their angles. */
function sortedFins(corners: readonly number[], positions: Float32Array, canonicalCorners: Uint32Array): Fin[] {
  const start = 3 * canonicalCorners[corners[0]];
  const end = 3 * canonicalCorners[nextCorner(corners[0])];
  const isAscending = comparePositions(positions, start, end) < 0;
  const origin = isAscending ? start : end;
  const axes = new EdgeAxes(positions, origin, isAscending ? end : start);
  const fins: Fin[] = [];
  for (const corner of corners) {
    const isForward = 3 * canonicalCorners[corner] === origin;
    const opposite = 3 * canonicalCorners[previousCorner(corner)];
    const angle = axes.angleOf(opposite);
    // The normal stands a quarter turn ahead of a forward triangle and a quarter turn behind a backward one.
    fins.push({ corner, isForward, angle: isForward ? angle : (angle + Math.PI) % TWO_PI, opposite });
  }
  return fins.sort(
    (a, b) =>
      a.angle - b.angle ||
      Number(b.isForward) - Number(a.isForward) ||
      comparePositions(positions, a.opposite, b.opposite) ||
      a.corner - b.corner,
  );
}

/** Lexicographic order of two positions, given as offsets. */
function comparePositions(positions: Float32Array, a: number, b: number): number {
  return positions[a] - positions[b] || positions[a + 1] - positions[b + 1] || positions[a + 2] - positions[b + 2] || 0;
}

/** Closest first; equal gaps in the order of angles. */
const precedes = (a: Candidate, b: Candidate): boolean => a.gap < b.gap || (a.gap === b.gap && a.left < b.left);

/** Binary heap: adds a candidate. Returns the number of steps taken. */
function push(heap: Candidate[], candidate: Candidate): number {
  let steps = 1;
  let child = heap.length;
  heap.push(candidate);
  while (child > 0) {
    const parent = (child - 1) >> 1;
    if (!precedes(candidate, heap[parent])) break;
    heap[child] = heap[parent];
    child = parent;
    steps++;
  }
  heap[child] = candidate;
  return steps;
}

/** Binary heap: drops the first candidate. Returns the number of steps taken. */
function pop(heap: Candidate[]): number {
  let steps = 1;
  const last = heap.pop()!;
  if (heap.length === 0) return steps;
  let parent = 0;
  for (;;) {
    let child = 2 * parent + 1;
    if (child >= heap.length) break;
    if (child + 1 < heap.length && precedes(heap[child + 1], heap[child])) child++;
    if (!precedes(heap[child], last)) break;
    heap[parent] = heap[child];
    parent = child;
    steps++;
  }
  heap[parent] = last;
  return steps;
}
