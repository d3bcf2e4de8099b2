import type { Branch, Junction, SkeletonGraph } from './SkeletonGraph.js';

/** An end of a branch: twice its index, plus one for its end instead of its start. */
type End = number;

/** A line through one or more branches. */
export interface Chain {
  /** x0, y0, x1, y1, … in pixels. */
  points: number[];
  /** The distance to paper at each point, in pixels. */
  radii: number[];
  /** Whether the chain returns to its start. */
  isClosed: boolean;
  /** The distance to paper at the start, if that lies in a stroke that the chain does not cross; 0 for a free end. */
  startRadius: number;
  /** The same for its end. */
  endRadius: number;
}

/** A branch with a free end up to this multiple of the distance to paper at its start, plus `SPUR_PIXELS`, is a spur. */
const SPUR_RADII = 1.3;
const SPUR_PIXELS = 2;
/** Two junctions are one crossing if the branch between them is shorter than this multiple of their distances to paper. */
const BRIDGE_RADII = 0.9;
/** Strokes that cross at small angles share up to this multiple of their width. */
const LONGEST_BRIDGE = 6;
/** Largest number of branches in one crossing, so that a texture of noise does not become a single one. */
const MOST_MEETING = 16;
/** Largest turn of a stroke at a crossing, in radians. */
const MOST_TURN = 0.8;
const MOST_TURN_OVER_BRIDGE = 0.45;

/**
 * Turns a graph into strokes: removes spurs, and continues crossing strokes straight.
 *
 * @returns the chains of branches, each of which is one stroke
 */
export function resolveJunctions(graph: SkeletonGraph): Chain[] {
  const work = new Crossings(graph);
  work.dropSpurs();
  work.mergeNear();
  work.mergeAlongBridges();
  work.pair();
  return work.chains();
}

class Crossings {
  private readonly branches: Branch[];
  private readonly nodes: Junction[];
  private readonly isGone: Uint8Array;
  /** The ends of branches at each node. */
  private readonly ends: End[][];
  /** The end that continues each end, or −1. */
  private readonly partners: Int32Array;
  /** The number of spurs removed at each node. */
  private readonly dropped: Uint8Array;

  constructor({ branches, nodes }: SkeletonGraph) {
    this.branches = branches;
    this.nodes = nodes;
    this.isGone = new Uint8Array(branches.length);
    this.partners = new Int32Array(2 * branches.length).fill(-1);
    this.ends = nodes.map(() => []);
    this.dropped = new Uint8Array(nodes.length);
    branches.forEach(({ from, to }, i) => {
      if (from >= 0) this.ends[from].push(2 * i);
      if (to >= 0) this.ends[to].push(2 * i + 1);
    });
  }

  /** Removes the short lines that thinning leaves towards the corners of a stroke and the bumps of its edge. */
  dropSpurs(): void {
    for (const [node, { radius }] of this.nodes.entries()) {
      const isSpur = (end: End): boolean =>
        this.nodeAt(end ^ 1) < 0 && this.lengthOf(end) < SPUR_RADII * radius + SPUR_PIXELS;
      const spurs = this.ends[node].filter(isSpur).sort((a, b) => this.lengthOf(a) - this.lengthOf(b));
      // Where all are short, the two longest are the stroke.
      const most = this.ends[node].length - (spurs.length === this.ends[node].length ? 2 : 1);
      this.dropped[node] = Math.min(spurs.length, most);
      for (const end of spurs.slice(0, most)) this.drop(end);
    }
  }

  /** Merges the two nodes with a short branch between them that a crossing of two wide strokes is thinned to. */
  mergeNear(): void {
    for (const [i, { from, to }] of this.branches.entries()) {
      if (this.isGone[i] || from < 0 || to < 0) continue;
      const reach = BRIDGE_RADII * (this.nodes[from].radius + this.nodes[to].radius) + 1;
      const meeting = this.ends[from].length + this.ends[to].length;
      if (this.lengthOf(2 * i) < reach && meeting <= MOST_MEETING) this.merge(i);
    }
  }

  /** Merges nodes along a longer branch, shared by strokes that cross at a small angle, if all four lines continue beyond it. */
  mergeAlongBridges(): void {
    for (const [i, { from, to }] of this.branches.entries()) {
      if (this.isGone[i] || from < 0 || to < 0 || from === to) continue;
      if (this.ends[from].length !== 3 || this.ends[to].length !== 3) continue;
      const reach = LONGEST_BRIDGE * (this.nodes[from].radius + this.nodes[to].radius);
      if (this.lengthOf(2 * i) > reach) continue;
      const [a1, a2] = this.ends[from].filter((end) => end >> 1 !== i);
      const [b1, b2] = this.ends[to].filter((end) => end >> 1 !== i);
      if (a1 === undefined || a2 === undefined || b1 === undefined || b2 === undefined) continue;
      const worst = Math.min(
        Math.max(this.turn(a1, b1), this.turn(a2, b2)),
        Math.max(this.turn(a1, b2), this.turn(a2, b1)),
      );
      if (worst < MOST_TURN_OVER_BRIDGE) this.merge(i);
    }
  }

  /** At every node pairs the two straightest ends, then the next two. */
  pair(): void {
    for (const [node, ends] of this.ends.entries()) {
      const pairs: { a: End; b: End; turn: number }[] = [];
      ends.forEach((a, i) => {
        for (const b of ends.slice(i + 1)) pairs.push({ a, b, turn: this.turn(a, b) });
      });
      pairs.sort((one, other) => one.turn - other.turn);
      // A sharp bend has one spur. Where two were removed, two strokes cross close to their ends.
      const most = ends.length === 2 && this.dropped[node] < 2 ? Math.PI : MOST_TURN;
      for (const { a, b, turn } of pairs) {
        if (turn > most || this.partners[a] >= 0 || this.partners[b] >= 0) continue;
        this.partners[a] = b;
        this.partners[b] = a;
      }
    }
  }

  chains(): Chain[] {
    const isUsed = this.isGone.slice();
    const chains: Chain[] = [];
    for (const loops of [false, true]) {
      for (let end = 0; end < this.partners.length; end++) {
        if (isUsed[end >> 1] || (!loops && this.partners[end] >= 0)) continue;
        chains.push(this.chainFrom(end, isUsed));
      }
    }
    return chains;
  }

  private chainFrom(start: End, isUsed: Uint8Array): Chain {
    const chain: Chain = { points: [], radii: [], isClosed: false, startRadius: this.radiusAt(start), endRadius: 0 };
    for (let end = start; ; ) {
      isUsed[end >> 1] = 1;
      this.append(chain, end);
      chain.endRadius = this.radiusAt(end ^ 1);
      const next = this.partners[end ^ 1];
      if (next < 0) break;
      if (isUsed[next >> 1]) {
        chain.isClosed = next === start;
        break;
      }
      end = next;
    }
    const { points, startRadius, endRadius } = chain;
    if (startRadius === 0 && endRadius === 0 && points.length > 16) {
      const gap = Math.hypot(points[0] - points[points.length - 2], points[1] - points[points.length - 1]);
      chain.isClosed ||= gap < 1.5;
    }
    return chain;
  }

  private radiusAt(end: End): number {
    const node = this.nodeAt(end);
    return node < 0 ? 0 : this.nodes[node].radius;
  }

  /** Appends the points of a branch from `end` on, without those near crossings, where lines are drawn towards each other. */
  private append({ points, radii }: Chain, end: End): void {
    const branch = this.branches[end >> 1];
    const isForward = (end & 1) === 0;
    const count = branch.radii.length;
    const isKept = (i: number): boolean =>
      [end, end ^ 1].every((side) => {
        if (this.partners[side] < 0) return true;
        const { x, y, radius } = this.nodes[this.nodeAt(side)];
        return Math.hypot(branch.points[2 * i] - x, branch.points[2 * i + 1] - y) > radius;
      });
    for (let step = 0; step < count; step++) {
      const i = isForward ? step : count - 1 - step;
      if (!isKept(i)) continue;
      points.push(branch.points[2 * i], branch.points[2 * i + 1]);
      radii.push(branch.radii[i]);
    }
  }

  private nodeAt(end: End): number {
    const { from, to } = this.branches[end >> 1];
    return end & 1 ? to : from;
  }

  private lengthOf(end: End): number {
    const { points, radii } = this.branches[end >> 1];
    const last = points.length - 2;
    // Along the chord and a little more: spurs and bridges are short.
    return Math.max(radii.length / Math.SQRT2, Math.hypot(points[last] - points[0], points[last + 1] - points[1]));
  }

  private drop(end: End): void {
    const i = end >> 1;
    this.isGone[i] = 1;
    for (const side of [2 * i, 2 * i + 1]) {
      const node = this.nodeAt(side);
      if (node >= 0) this.ends[node] = this.ends[node].filter((other) => other !== side);
    }
  }

  /** Merges the two nodes of a branch, and removes the branch. */
  private merge(i: number): void {
    const { from, to } = this.branches[i];
    this.drop(2 * i);
    if (from === to) return;
    const [a, b] = [this.nodes[from], this.nodes[to]];
    const reach = 0.5 * Math.hypot(a.x - b.x, a.y - b.y);
    this.nodes[from] = {
      x: 0.5 * (a.x + b.x),
      y: 0.5 * (a.y + b.y),
      radius: Math.max(a.radius, b.radius, reach + 0.5 * Math.min(a.radius, b.radius)),
    };
    this.dropped[from] += this.dropped[to];
    for (const end of this.ends[to]) {
      const branch = this.branches[end >> 1];
      if (end & 1) branch.to = from;
      else branch.from = from;
    }
    this.ends[from].push(...this.ends[to]);
    this.ends[to] = [];
  }

  /** The deviation from straight between two ends, in radians, by way of the line between them. */
  private turn(a: End, b: End): number {
    if (a >> 1 === b >> 1) return Math.PI;
    const [one, other] = [this.heading(a), this.heading(b)];
    const turn = angleBetween(one.x, one.y, -other.x, -other.y);
    const across = other.atX - one.atX;
    const down = other.atY - one.atY;
    if (Math.hypot(across, down) < 2) return turn;
    return Math.max(
      turn,
      0.8 * angleBetween(across, down, -one.x, -one.y),
      0.8 * angleBetween(across, down, other.x, other.y),
    );
  }

  /** The point where a branch finally leaves its node, and its direction from there. */
  private heading(end: End): { atX: number; atY: number; x: number; y: number } {
    const { points, radii } = this.branches[end >> 1];
    const node = this.nodes[this.nodeAt(end)];
    const count = radii.length;
    const at = (step: number): number => 2 * ((end & 1) === 0 ? step : count - 1 - step);
    const distance = (step: number): number => Math.hypot(points[at(step)] - node.x, points[at(step) + 1] - node.y);
    let near = 0;
    while (near < count - 1 && distance(near) < 1.2 * node.radius) near++;
    let far = near;
    while (far < count - 1 && distance(far) < 2 * node.radius + 10) far++;
    // A branch that is all near its node points away from it.
    const isShort = far - near < 3;
    const atX = isShort ? node.x : points[at(near)];
    const atY = isShort ? node.y : points[at(near) + 1];
    const x = points[at(far)] - atX;
    const y = points[at(far) + 1] - atY;
    const length = Math.hypot(x, y) || 1;
    return { atX, atY, x: x / length, y: y / length };
  }
}

const angleBetween = (ax: number, ay: number, bx: number, by: number): number =>
  Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
