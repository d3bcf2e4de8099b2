import { nextCorner, previousCorner } from '../corners.js';

/** A half-edge of a non-manifold edge. */
interface HalfEdge {
  corner: number;
  /** Whether it runs from the lexicographically smaller end to the larger one. */
  isForward: boolean;
  /** Angle of the triangle's normal about the edge, up to a constant, in [0, 2π). */
  angle: number;
  /** Offset in `positions` of the vertex opposite to the edge. */
  opposite: number;
}

/** Two half-edges next to each other in angle, one forward and one backward, that may become twins. */
interface Candidate {
  /** The angle from `left` to `right`, in [0, 2π). */
  gap: number;
  left: number;
  right: number;
}

/** The results that the pairing of a non-manifold edge is added to. See `EdgeCounts`. */
interface EdgePairing {
  twins: Int32Array;
  nonManifoldEdges: number;
  unpairedEdges: number;
  /** The number of steps taken. */
  steps: number;
}

const TWO_PI = 2 * Math.PI;

/**
 * Pairs the half-edges `corners` of an edge that more than two triangles share. A pair consists of a forward and a backward
 * half-edge. The pair with the closest normals is matched first (the rule of DirectXMesh), then the next, until no forward
 * or no backward half-edge is left. The rest get no twin.
 *
 * All normals are perpendicular to the edge, so each is an angle about it. The closest pair are always neighbours in the
 * order of angles, so O(n log n) steps replace the comparison of all pairs. Angles and tie-breaks depend on positions
 * alone, so the order of triangles and vertices in the mesh does not matter. Only identical copies of a triangle are ordered
 * by their corners.
 */
export function matchNonManifoldEdge(
  corners: readonly number[],
  positions: Float32Array,
  canonicalCorners: Uint32Array,
  pairing: EdgePairing,
): void {
  const { twins } = pairing;
  const halfEdges = sortHalfEdges(corners, positions, canonicalCorners);
  const count = halfEdges.length;
  let steps = count;
  const before = halfEdges.map((_, i) => (i + count - 1) % count);
  const after = halfEdges.map((_, i) => (i + 1) % count);
  const isMatched = new Uint8Array(count);
  const heap: Candidate[] = [];

  const consider = (left: number, right: number): void => {
    if (left === right || halfEdges[left].isForward === halfEdges[right].isForward) return;
    const gap = (halfEdges[right].angle - halfEdges[left].angle + TWO_PI) % TWO_PI;
    steps += push(heap, { gap, left, right });
  };
  for (let i = 0; i < count; i++) consider(i, after[i]);

  while (heap.length > 0) {
    const { left, right } = heap[0];
    steps += pop(heap);
    if (isMatched[left] || isMatched[right]) continue;
    isMatched[left] = 1;
    isMatched[right] = 1;
    twins[halfEdges[left].corner] = halfEdges[right].corner;
    twins[halfEdges[right].corner] = halfEdges[left].corner;
    const outerLeft = before[left];
    const outerRight = after[right];
    if (isMatched[outerLeft] || isMatched[outerRight]) continue;
    after[outerLeft] = outerRight;
    before[outerRight] = outerLeft;
    consider(outerLeft, outerRight);
  }
  pairing.steps += steps;
  pairing.nonManifoldEdges++;
  if (isMatched.includes(0)) pairing.unpairedEdges++;
}

/** Returns the half-edges, sorted by angle. */
function sortHalfEdges(corners: readonly number[], positions: Float32Array, canonicalCorners: Uint32Array): HalfEdge[] {
  const start = 3 * canonicalCorners[corners[0]];
  const end = 3 * canonicalCorners[nextCorner(corners[0])];
  const isAscending = comparePositions(positions, start, end) < 0;
  const origin = isAscending ? start : end;
  const axes = new EdgeAxes(positions, origin, isAscending ? end : start);
  const halfEdges: HalfEdge[] = [];
  for (const corner of corners) {
    const isForward = 3 * canonicalCorners[corner] === origin;
    const opposite = 3 * canonicalCorners[previousCorner(corner)];
    const angle = axes.angleOf(opposite);
    // The normal is a quarter turn ahead of a forward triangle and a quarter turn behind a backward one.
    halfEdges.push({ corner, isForward, angle: isForward ? angle : (angle + Math.PI) % TWO_PI, opposite });
  }
  return halfEdges.sort(
    (a, b) =>
      a.angle - b.angle ||
      Number(b.isForward) - Number(a.isForward) ||
      comparePositions(positions, a.opposite, b.opposite) ||
      a.corner - b.corner,
  );
}

/** Lexicographic order of two positions, given as offsets. */
export function comparePositions(positions: Float32Array, a: number, b: number): number {
  return positions[a] - positions[b] || positions[a + 1] - positions[b + 1] || positions[a + 2] - positions[b + 2] || 0;
}

/** The order of the heap: the closest pair first, and equal gaps in the order of angles. */
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

/** Measures angles about an edge. Its axes are two unit vectors u and v, perpendicular to the edge and to each other. */
class EdgeAxes {
  private readonly ux: number;
  private readonly uy: number;
  private readonly uz: number;
  private readonly vx: number;
  private readonly vy: number;
  private readonly vz: number;

  constructor(
    private readonly positions: Float32Array,
    private readonly origin: number,
    target: number,
  ) {
    let x = positions[target] - positions[origin];
    let y = positions[target + 1] - positions[origin + 1];
    let z = positions[target + 2] - positions[origin + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    x /= length;
    y /= length;
    z /= length;
    // u is the cross product of the edge with the coordinate axis that it is least aligned with; v = edge × u.
    const ax = Math.abs(x);
    const ay = Math.abs(y);
    const az = Math.abs(z);
    let ux = 0;
    let uy = 0;
    let uz = 0;
    if (ax <= ay && ax <= az) {
      uy = z;
      uz = -y;
    } else if (ay <= az) {
      ux = -z;
      uz = x;
    } else {
      ux = y;
      uy = -x;
    }
    const scale = 1 / Math.sqrt(ux * ux + uy * uy + uz * uz);
    this.ux = ux * scale;
    this.uy = uy * scale;
    this.uz = uz * scale;
    this.vx = y * this.uz - z * this.uy;
    this.vy = z * this.ux - x * this.uz;
    this.vz = x * this.uy - y * this.ux;
  }

  /** The angle of a position about the edge, in [0, 2π). */
  angleOf(position: number): number {
    const { positions, origin } = this;
    const x = positions[position] - positions[origin];
    const y = positions[position + 1] - positions[origin + 1];
    const z = positions[position + 2] - positions[origin + 2];
    const angle = Math.atan2(x * this.vx + y * this.vy + z * this.vz, x * this.ux + y * this.uy + z * this.uz);
    // A tiny negative angle plus 2π rounds to 2π; the remainder makes that 0.
    return angle < 0 ? (angle + TWO_PI) % TWO_PI : angle;
  }
}
