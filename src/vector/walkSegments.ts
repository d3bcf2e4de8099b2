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
