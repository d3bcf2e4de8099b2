import type { MeetingMesh } from './MeetingMesh.js';
import { sideOf } from './sideOf.js';
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
 * Finds the segments along which two meshes cut each other; of a mesh with itself those between its shells. Triangles that share a vertex
 * have none. Each pair of triangles has one or none: signs of orientation are exact, and none is 0. Segments whose ends lie on the same edge
 * and triangle share the end. Yields its progress; null if the work was not enough.
 */
export function* crossMeshes(
  first: MeetingMesh,
  second: MeetingMesh,
  work: Work,
): Generator<number, Crossings | null, void> {
  const crossing = new Crossing(first, second, work);
  const { tree: a } = first;
  const { tree: b } = second;
  if (a.order.length === 0 || b.order.length === 0) return crossing.found;
  const isSelf = first === second;
  const waiting = [0, 0];
  let steps = 0;
  while (waiting.length > 0) {
    const n = waiting.pop()!;
    const m = waiting.pop()!;
    work.left--;
    if (++steps % CHUNK === 0) yield 0.5;
    if (isSelf && a.shells[m] !== MIXED && a.shells[m] === a.shells[n]) continue;
    if (!boxesMeet(a.boxes, BOX * m, b.boxes, BOX * n)) continue;
    const [isLeafA, isLeafB] = [a.firsts[m] < 0, b.firsts[n] < 0];
    if (isLeafA && isLeafB) {
      crossing.meetLeaves(m, n);
      if (work.left < 0) return null;
    } else if (isSelf && m === n) {
      const child = a.firsts[m];
      waiting.push(child, child, child, child + 1, child + 1, child + 1);
    } else if (isLeafB || (!isLeafA && a.counts[m] >= b.counts[n])) {
      waiting.push(a.firsts[m], n, a.firsts[m] + 1, n);
    } else waiting.push(m, b.firsts[n], m, b.firsts[n] + 1);
  }
  return crossing.found;
}

class Crossing {
  readonly found: Crossings = { places: [], segments: [] };
  /** The ends on edges of the first mesh and in triangles of the second, and the other way round, by both their numbers. */
  private readonly ends = [new Map<number, number>(), new Map<number, number>()];
  /** Sides of the corners of a triangle. */
  private readonly sides = [new Int8Array(3), new Int8Array(3)];

  constructor(
    private readonly first: MeetingMesh,
    private readonly second: MeetingMesh,
    private readonly work: Work,
  ) {}

  meetLeaves(m: number, n: number): void {
    const { first, second } = this;
    const [a, b] = [first.tree, second.tree];
    const isSelf = first === second;
    for (let i = -1 - a.firsts[m], end = i + a.counts[m]; i < end; i++) {
      const s = a.order[i];
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
    const { first, second, found } = this;
    const [ofFirst, ofSecond] = this.sides;
    this.work.left -= PAIR_WORK;
    if (haveVertexInCommon(first, s, second, t)) return;
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
    const [from, to] = [mesh.vertices[e + edge], mesh.vertices[e + ((edge + 1) % 3)]];
    const [low, high] = from < to ? [from, to] : [to, from];
    const key = mesh.edgeNumber(low, high) * other.shells.length + through;
    const known = this.ends[which].get(key);
    if (known !== undefined) return known;
    const p = mesh.places;
    const q = other.places;
    const [a, b] = [3 * low, 3 * high];
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
    this.ends[which].set(key, end);
    return end;
  }

  private addEnd(p: Float64Array, a: number, b: number, { vertices, places: q }: MeetingMesh, through: number): number {
    const { places } = this.found;
    const [c, d, e] = [3 * vertices[3 * through], 3 * vertices[3 * through + 1], 3 * vertices[3 * through + 2]];
    const [ux, uy, uz] = [q[d] - q[c], q[d + 1] - q[c + 1], q[d + 2] - q[c + 2]];
    const [vx, vy, vz] = [q[e] - q[c], q[e + 1] - q[c + 1], q[e + 2] - q[c + 2]];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const away = (i: number): number => x * (p[i] - q[c]) + y * (p[i + 1] - q[c + 1]) + z * (p[i + 2] - q[c + 2]);
    const [start, stop] = [away(a), away(b)];
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
  for (let k = 0; k < 3; k++) {
    const v = 3 * vertices[3 * triangle + k];
    sides[k] = sideOf(
      p[v] - q[a],
      p[v + 1] - q[a + 1],
      p[v + 2] - q[a + 2],
      q[b] - q[a],
      q[b + 1] - q[a + 1],
      q[b + 2] - q[a + 2],
      q[c] - q[a],
      q[c + 1] - q[a + 1],
      q[c + 2] - q[a + 2],
      shift,
    );
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

function haveVertexInCommon(first: MeetingMesh, s: number, second: MeetingMesh, t: number): boolean {
  for (let i = 3 * s; i < 3 * s + 3; i++) {
    const a = 3 * first.vertices[i];
    for (let j = 3 * t; j < 3 * t + 3; j++) {
      const b = 3 * second.vertices[j];
      if (
        first.places[a] === second.places[b] &&
        first.places[a + 1] === second.places[b + 1] &&
        first.places[a + 2] === second.places[b + 2]
      )
        return true;
    }
  }
  return false;
}
