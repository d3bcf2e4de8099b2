import type { LineSurface } from './LineSurface.js';

/** Rank of a triangle without lines. */
export const NO_RANK = 0x7fff;

/** Most lines of a triangle; where a function is steeper, lines would be one grey. */
const MOST_IN_TRIANGLE = 1 << 12;

/** The level sets of a function on the triangles of a surface, as segments between edges. */
export interface LevelSegments {
  /** The finest power of two that lines are multiples of, as an exponent. */
  finest: number;
  /**
   * Nodes, where a line crosses an edge: the line as a multiple of that power, the places at the ends of the edge, and the share between
   * them.
   */
  lines: number[];
  from: number[];
  to: number[];
  shares: number[];
  /** Segments: the nodes at both ends, and the triangle. */
  starts: number[];
  ends: number[];
  triangles: number[];
}

/** Offsets of lines from their level sets. */
export interface LineOffsets {
  /** The offset of a line at a vertex, in units of the function. */
  at(value: number, vertex: number): number;
  /** The greatest offset at a vertex. */
  mostAt(vertex: number): number;
}

const NO_OFFSETS: LineOffsets = { at: () => 0, mostAt: () => 0 };

/**
 * Cuts triangles along all level sets that they have lines of.
 *
 * @param values of the function at the vertices
 * @param ranks per triangle the exponent of the power of two whose multiples it needs, or NO_RANK
 * @param hasSeams whether values may differ at one place, so that nodes of both sides are joined by position
 * @param aside offsets of the lines, if any
 */
export function* levelSegments(
  { triangles, placeOf }: LineSurface,
  values: Float64Array,
  ranks: Int16Array,
  hasSeams: boolean,
  aside = NO_OFFSETS,
): Generator<number, LevelSegments, void> {
  let finest = NO_RANK;
  for (let t = 0; t < ranks.length; t++) finest = Math.min(finest, ranks[t]);
  const segments: LevelSegments = {
    finest,
    ...{ lines: [], from: [], to: [], shares: [], starts: [], ends: [], triangles: [] },
  };
  const nodes = new Map<number, Map<number, number>>();
  const unit = 2 ** finest;
  /** The value of the function above a line at a vertex. */
  const aboveAt = (v: number, line: number): number => values[v] - line * unit - aside.at(line * unit, v);
  /** The node where a line crosses the edge between two vertices. */
  const nodeAt = (u: number, v: number, line: number): number => {
    const [a, b] = placeOf[u] < placeOf[v] ? [u, v] : [v, u];
    const [i, j] = hasSeams ? [a, b] : [placeOf[a], placeOf[b]];
    const key = i * 2 ** 26 + j;
    const ofEdge = nodes.get(key) ?? new Map<number, number>();
    if (ofEdge.size === 0) nodes.set(key, ofEdge);
    let node = ofEdge.get(line);
    if (node === undefined) {
      node = segments.lines.length;
      ofEdge.set(line, node);
      segments.lines.push(line);
      segments.from.push(placeOf[a]);
      segments.to.push(placeOf[b]);
      const [low, high] = [aboveAt(a, line), aboveAt(b, line)];
      segments.shares.push(low / (low - high));
    }
    return node;
  };
  for (let t = 0; t < ranks.length; t++) {
    if (t % 1024 === 1023) yield t / ranks.length;
    if (ranks[t] === NO_RANK) continue;
    const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
    const beside = Math.max(aside.mostAt(a), aside.mostAt(b), aside.mostAt(c));
    const least = (Math.min(values[a], values[b], values[c]) - beside) / unit;
    const most = (Math.max(values[a], values[b], values[c]) + beside) / unit;
    const step = 2 ** (ranks[t] - finest);
    if (!((most - least) / step < MOST_IN_TRIANGLE)) continue;
    for (let line = Math.ceil(least / step) * step; line <= most; line += step) {
      // A corner on the line counts as above it.
      const [isA, isB, isC] = [aboveAt(a, line) >= 0, aboveAt(b, line) >= 0, aboveAt(c, line) >= 0];
      if (isA === isB && isB === isC) continue;
      const [alone, one, two] = isB === isC ? [a, b, c] : isA === isC ? [b, c, a] : [c, a, b];
      segments.starts.push(nodeAt(alone, one, line));
      segments.ends.push(nodeAt(alone, two, line));
      segments.triangles.push(t);
    }
  }
  if (hasSeams) {
    yield 1;
    yield* joinAcrossSeams(segments);
  }
  return segments;
}

/** Greatest distance between two ends on an edge that are joined, as a share of its length. */
const SEAM_TOLERANCE = 1e-3;

/** Joins nodes at which a segment ends with those at the same place on the other side of a seam, where the line has another number. */
function* joinAcrossSeams({ from, to, shares, starts, ends }: LevelSegments): Generator<number, void, void> {
  const uses = new Uint8Array(shares.length);
  for (const list of [starts, ends]) for (const node of list) uses[node]++;
  yield 1;
  const open = new Map<number, number[]>();
  for (let node = 0; node < shares.length; node++) {
    if (node % 8192 === 8191) yield 1;
    if (uses[node] !== 1) continue;
    const key = from[node] * 2 ** 26 + to[node];
    const list = open.get(key);
    if (list) list.push(node);
    else open.set(key, [node]);
  }
  const joined = new Map<number, number>();
  yield 1;
  for (const nodes of open.values()) {
    nodes.sort((a, b) => shares[a] - shares[b]);
    for (let i = 0; i + 1 < nodes.length; i++) {
      if (shares[nodes[i + 1]] - shares[nodes[i]] > SEAM_TOLERANCE) continue;
      joined.set(nodes[i + 1], nodes[i]);
      i++;
    }
  }
  for (const list of [starts, ends]) {
    yield 1;
    for (let i = 0; i < list.length; i++) list[i] = joined.get(list[i]) ?? list[i];
  }
}

/** A walk along segments that share nodes: the segments in order, and whether the last leads back to the first. */
export interface Walk {
  /** The first node. */
  start: number;
  segments: number[];
  isClosed: boolean;
}

/** Segments per step. */
const CHUNK = 4096;

/**
 * Joins segments to walks, each segment once. Two segments at a node are joined; further ones begin walks of their own. Yields null when
 * there is more to do before the next walk.
 */
export function* walkSegments(
  starts: readonly number[],
  ends: readonly number[],
  nodes: number,
): Generator<Walk | null, void, void> {
  const links = new Int32Array(2 * nodes).fill(-1);
  const link = (node: number, segment: number): void => {
    if (links[2 * node] < 0) links[2 * node] = segment;
    else if (links[2 * node + 1] < 0) links[2 * node + 1] = segment;
  };
  for (let s = 0; s < starts.length; s++) {
    if (s % CHUNK === CHUNK - 1) yield null;
    link(starts[s], s);
    link(ends[s], s);
  }
  const otherEnd = (s: number, node: number): number => (starts[s] === node ? ends[s] : starts[s]);
  const used = new Uint8Array(starts.length);
  /** The segment that continues one at a node. */
  const after = (s: number, node: number): number => {
    const [a, b] = [links[2 * node], links[2 * node + 1]];
    if (a === s) return b;
    return b === s ? a : -1;
  };
  for (let first = 0; first < starts.length; first++) {
    if (used[first]) continue;
    // Back to the beginning of the line, or all the way round.
    let segment = first;
    let node = starts[first];
    for (;;) {
      const before = after(segment, node);
      if (before < 0 || before === first || used[before]) break;
      segment = before;
      node = otherEnd(before, node);
    }
    const walk: Walk = { start: node, segments: [], isClosed: false };
    while (segment >= 0 && !used[segment]) {
      used[segment] = 1;
      walk.segments.push(segment);
      node = otherEnd(segment, node);
      segment = after(segment, node);
    }
    walk.isClosed = walk.segments.length > 2 && node === walk.start;
    yield walk;
  }
}
