import { EndTable } from './EndTable.js';
import type { MeetingMesh } from './MeetingMesh.js';
import { sideOf, TRIPLE_ERROR, tripleSign } from './sideOf.js';
import { BOX, boxesMeet, MIXED } from './TriangleTree.js';

/** Pairs of nodes and triangles per step. */
const CHUNK = 2048;

/** Work per pair of triangles whose boxes meet, and per segment that is found. A pair of nodes counts as 1. */
const PAIR_WORK = 8;
const SEGMENT_WORK = 64;

/** How much work is left. */
export interface Work {
  left: number;
}

/** Segments along which the surfaces of two meshes cut each other. */
export interface Crossings {
  /** x, y, z of each end, in steps of the grid. */
  places: number[];
  /** For each segment its two ends, its triangle of the first mesh and that of the second. */
  segments: number[];
}

/** Numbers per segment in `Crossings`. */
export const SEGMENT = 4;

/**
 * Finds the segments along which two meshes cut each other; of a mesh with itself those between its shells. Triangles that share an edge
 * have none, and those that share a vertex only where they cut each other beyond it. Each pair of triangles has one or none: signs of orientation are exact, and none is 0. Segments whose ends lie on the same edge
 * and triangle share the end. Yields its progress; null if the work was not enough.
 */
export function* crossMeshes(
  first: MeetingMesh,
  second: MeetingMesh,
  work: Work,
): Generator<number, Crossings | null, void> {
  const { tree: a } = first;
  const { tree: b } = second;
  const isSelf = first === second;
  const isWhole = isSelf && a.shells[0] !== MIXED;
  if (isWhole || a.order.length === 0 || b.order.length === 0) return { places: [], segments: [] };
  const crossing = new Crossing(first, second, work);
  const waiting = [0, 0];
  let steps = 0;
  while (waiting.length > 0) {
    const n = waiting.pop()!;
    const m = waiting.pop()!;
    work.left--;
    if (++steps % CHUNK === 0) yield 0.5;
    if (isSelf && a.shells[m] !== MIXED && a.shells[m] === a.shells[n]) continue;
    if (!boxesMeet(a.boxes, BOX * m, b.boxes, BOX * n)) continue;
    const isLeafA = a.firsts[m] < 0;
    const isLeafB = b.firsts[n] < 0;
    if (isLeafA && isLeafB) {
      crossing.meetLeaves(m, n);
      if (work.left < 0) return null;
    } else if (isSelf && m === n) {
      const child = a.firsts[m];
      waiting.push(child, child, child, child + 1, child + 1, child + 1);
    } else if (isLeafB || (!isLeafA && a.sizes[m] >= b.sizes[n])) {
      waiting.push(a.firsts[m], n, a.firsts[m] + 1, n);
    } else waiting.push(m, b.firsts[n], m, b.firsts[n] + 1);
  }
  return crossing.found;
}

class Crossing {
  readonly found: Crossings = { places: [], segments: [] };
  /** The ends on edges of the first mesh and in triangles of the second, and the other way round, by both their numbers. */
  private readonly ends = [new EndTable(), new EndTable()] as const;
  /** Sides of the corners of a triangle of each mesh. */
  private readonly ofFirst = new Int8Array(3);
  private readonly ofSecond = new Int8Array(3);

  constructor(
    private readonly first: MeetingMesh,
    private readonly second: MeetingMesh,
    private readonly work: Work,
  ) {}

  meetLeaves(m: number, n: number): void {
    const { first, second } = this;
    const { tree: a } = first;
    const { tree: b } = second;
    const isSelf = first === second;
    for (let i = -1 - a.firsts[m], end = i + a.counts[m]; i < end; i++) {
      const s = a.order[i];
      if (!boxesMeet(a.triangleBoxes, BOX * s, b.boxes, BOX * n)) continue;
      for (let j = -1 - b.firsts[n], last = j + b.counts[n]; j < last; j++) {
        const t = b.order[j];
        if (isSelf && (first.shells[s] === first.shells[t] || (m === n && s > t))) continue;
        if (!boxesMeet(a.triangleBoxes, BOX * s, b.triangleBoxes, BOX * t)) continue;
        if (isSelf && first.shells[s] > first.shells[t]) this.meet(t, s);
        else this.meet(s, t);
      }
    }
  }

  private meet(s: number, t: number): void {
    const { first, second, found, ofFirst, ofSecond } = this;
    this.work.left -= PAIR_WORK;
    const common = commonVertices(first, s, second, t);
    if (common === SEVERAL) return;
    if (common !== NONE) {
      this.meetAtVertex(s, (common / 3) | 0, t, common % 3);
      return;
    }
    if (!areApart(first, s, second, t, -1, ofFirst) || !areApart(second, t, first, s, 1, ofSecond)) return;
    let from = -1;
    for (let k = 0; k < 6; k++) {
      const isOfFirst = k < 3;
      const edge = k % 3;
      const sides = isOfFirst ? ofFirst : ofSecond;
      if (sides[edge] === sides[(edge + 1) % 3]) continue;
      const end = isOfFirst ? this.endAt(0, first, s, edge, second, t) : this.endAt(1, second, t, edge, first, s);
      if (end < 0 || end === from) continue;
      if (from < 0) from = end;
      else {
        found.segments.push(from, end, s, t);
        this.work.left -= SEGMENT_WORK;
        return;
      }
    }
  }

  /**
   * Adds the segment of two triangles that cut each other from a vertex on which both have, at their corners i and j. What only touches
   * there, as at a seam, has none.
   */
  private meetAtVertex(s: number, i: number, t: number, j: number): void {
    const { first, second, found } = this;
    const [afterI, beforeI, afterJ, beforeJ] = [(i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3];
    const p = first.places;
    const q = second.places;
    const v = 3 * first.vertices[3 * s + i];
    const w = 3 * second.vertices[3 * t + j];
    const a = 3 * first.vertices[3 * s + afterI];
    const b = 3 * first.vertices[3 * s + beforeI];
    const c = 3 * second.vertices[3 * t + afterJ];
    const d = 3 * second.vertices[3 * t + beforeJ];
    if (!arePlaneBetween(p, a, b, q, w, c, d) || !arePlaneBetween(q, c, d, p, v, a, b)) return;
    // The edge that lies opposite passes both sides of the other corner in one sense, or the triangles lie on different sides of the vertex.
    if (edgeSide(p, a, b, q, w, c) !== edgeSide(p, a, b, q, d, w)) return;
    const inSecond = this.endAt(0, first, s, afterI, second, t);
    const far = inSecond < 0 ? this.endAt(1, second, t, afterJ, first, s) : inSecond;
    if (far < 0) return;
    found.segments.push(this.endAtVertex(first, v / 3), far, s, t);
    this.work.left -= SEGMENT_WORK;
  }

  /** The end at a vertex of the first mesh. */
  private endAtVertex({ places: p }: MeetingMesh, vertex: number): number {
    const { places } = this.found;
    const [ends] = this.ends;
    // No edge has one vertex at both its ends.
    const slot = ends.slotOf(vertex, vertex, 0);
    if (ends.has(slot)) return ends.at(slot);
    places.push(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
    ends.set(slot, vertex, vertex, 0, places.length / 3 - 1);
    return places.length / 3 - 1;
  }

  /** The end on an edge of one triangle in another; −1 if the edge passes beside that. */
  private endAt(
    which: 0 | 1,
    mesh: MeetingMesh,
    triangle: number,
    edge: number,
    other: MeetingMesh,
    through: number,
  ): number {
    const e = 3 * triangle;
    const from = mesh.vertices[e + edge];
    const to = mesh.vertices[e + ((edge + 1) % 3)];
    const low = Math.min(from, to);
    const high = Math.max(from, to);
    const ends = this.ends[which];
    const slot = ends.slotOf(low, high, through);
    if (ends.has(slot)) return ends.at(slot);
    const p = mesh.places;
    const q = other.places;
    const a = 3 * low;
    const b = 3 * high;
    let turn = 0;
    let end = 0;
    for (let k = 0; k < 3 && end === 0; k++) {
      const c = 3 * other.vertices[3 * through + k];
      const d = 3 * other.vertices[3 * through + ((k + 1) % 3)];
      // Of two edges, that of the second surface is the one that moves.
      const side = which === 0 ? edgeSide(p, a, b, q, c, d) : edgeSide(q, c, d, p, a, b);
      if (k > 0 && side !== turn) end = -1;
      turn = side;
    }
    if (end === 0) end = this.addEnd(p, a, b, other, through);
    ends.set(slot, low, high, through, end);
    return end;
  }

  private addEnd(p: Float64Array, a: number, b: number, { vertices, places: q }: MeetingMesh, through: number): number {
    const { places } = this.found;
    const c = 3 * vertices[3 * through];
    const d = 3 * vertices[3 * through + 1];
    const e = 3 * vertices[3 * through + 2];
    const ux = q[d] - q[c];
    const uy = q[d + 1] - q[c + 1];
    const uz = q[d + 2] - q[c + 2];
    const vx = q[e] - q[c];
    const vy = q[e + 1] - q[c + 1];
    const vz = q[e + 2] - q[c + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const start = x * (p[a] - q[c]) + y * (p[a + 1] - q[c + 1]) + z * (p[a + 2] - q[c + 2]);
    const stop = x * (p[b] - q[c]) + y * (p[b + 1] - q[c + 1]) + z * (p[b + 2] - q[c + 2]);
    const share = start === stop ? 0.5 : Math.min(Math.max(start / (start - stop), 0), 1);
    for (let axis = 0; axis < 3; axis++) places.push(p[a + axis] + share * (p[b + axis] - p[a + axis]));
    return places.length / 3 - 1;
  }
}

/** Whether the corners of a triangle lie on both sides of the plane of another. Writes their sides. */
function areApart(
  { vertices, places: p }: MeetingMesh,
  triangle: number,
  other: MeetingMesh,
  plane: number,
  shift: 1 | -1,
  sides: Int8Array,
): boolean {
  const q = other.places;
  const a = 3 * other.vertices[3 * plane];
  const b = 3 * other.vertices[3 * plane + 1];
  const c = 3 * other.vertices[3 * plane + 2];
  const [ux, uy, uz] = [q[b] - q[a], q[b + 1] - q[a + 1], q[b + 2] - q[a + 2]];
  const [vx, vy, vz] = [q[c] - q[a], q[c + 1] - q[a + 1], q[c + 2] - q[a + 2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const termX = Math.abs(uy * vz) + Math.abs(uz * vy);
  const termY = Math.abs(uz * vx) + Math.abs(ux * vz);
  const termZ = Math.abs(ux * vy) + Math.abs(uy * vx);
  for (let k = 0; k < 3; k++) {
    const v = 3 * vertices[3 * triangle + k];
    const [wx, wy, wz] = [p[v] - q[a], p[v + 1] - q[a + 1], p[v + 2] - q[a + 2]];
    const product = wx * x + wy * y + wz * z;
    const error = TRIPLE_ERROR * (termX * Math.abs(wx) + termY * Math.abs(wy) + termZ * Math.abs(wz));
    if (product > error) sides[k] = 1;
    else if (-product > error) sides[k] = -1;
    else sides[k] = sideOf(wx, wy, wz, ux, uy, uz, vx, vy, vz, shift);
  }
  return sides[0] !== sides[1] || sides[0] !== sides[2];
}

/** The sense in which a line of the second surface, from c to d, passes one of the first, from a to b. */
const edgeSide = (p: Float64Array, a: number, b: number, q: Float64Array, c: number, d: number): number =>
  sideOf(
    q[c] - p[a],
    q[c + 1] - p[a + 1],
    q[c + 2] - p[a + 2],
    q[d] - q[c],
    q[d + 1] - q[c + 1],
    q[d + 2] - q[c + 2],
    p[b] - p[a],
    p[b + 1] - p[a + 1],
    p[b + 2] - p[a + 2],
    1,
  );

/** What `commonVertices` says of triangles without a vertex in common, and of those with more than one. */
const NONE = -1;
const SEVERAL = 9;

/** The corners of two triangles that lie at the same place: 3 times that of the first, and that of the second. */
function commonVertices(first: MeetingMesh, s: number, second: MeetingMesh, t: number): number {
  let found = NONE;
  for (let i = 0; i < 3; i++) {
    const a = 3 * first.vertices[3 * s + i];
    for (let j = 0; j < 3; j++) {
      const b = 3 * second.vertices[3 * t + j];
      if (
        first.places[a] === second.places[b] &&
        first.places[a + 1] === second.places[b + 1] &&
        first.places[a + 2] === second.places[b + 2]
      ) {
        if (found !== NONE) return SEVERAL;
        found = 3 * i + j;
      }
    }
  }
  return found;
}

/** Whether two corners of a triangle lie on different sides of the plane of another, and neither on it. */
function arePlaneBetween(
  p: Float64Array,
  a: number,
  b: number,
  q: Float64Array,
  v: number,
  c: number,
  d: number,
): boolean {
  return exactSide(p, a, q, v, c, d) * exactSide(p, b, q, v, c, d) < 0;
}

/** The side of a plane through v, c and d on which a place lies; 0 on it. */
const exactSide = (p: Float64Array, a: number, q: Float64Array, v: number, c: number, d: number): number =>
  tripleSign(
    p[a] - q[v],
    p[a + 1] - q[v + 1],
    p[a + 2] - q[v + 2],
    q[c] - q[v],
    q[c + 1] - q[v + 1],
    q[c + 2] - q[v + 2],
    q[d] - q[v],
    q[d + 1] - q[v + 1],
    q[d + 2] - q[v + 2],
  );
