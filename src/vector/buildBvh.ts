import { TriangleSplitter } from './TriangleSplitter.js';

/** A bounding volume hierarchy over triangles, as flat arrays. */
export interface BvhNodes {
  /** Six numbers per node: the least corner of its box, and the greatest. */
  bounds: Float32Array;
  /** For an inner node its left child, which the right one follows; for a leaf its first triangle in `order`. */
  child: Int32Array;
  /** The number of triangles of a leaf; 0 for inner nodes. */
  leafCount: Uint8Array;
  /** Triangle indices in leaf order. */
  order: Uint32Array;
}

const MOST_IN_LEAF = 4;
/** Triangles per step. */
const CHUNK = 1 << 14;
/** The share of the work that computing boxes takes. */
const BOXES = 0.1;

/** The number of visits to the triangles of a range until all are in leaves, about. */
const workOf = (size: number): number => size * Math.max(Math.log2(size) - 1, 1);

/** Builds the hierarchy by the surface area heuristic over bins. Yields its progress. */
export function* buildBvh(corners: Float64Array): Generator<number, BvhNodes, void> {
  const count = corners.length / 9;
  const splitter = new TriangleSplitter(count);
  for (let start = 0; start < count; start += CHUNK) {
    const end = Math.min(start + CHUNK, count);
    splitter.readBoxes(corners, start, end);
    yield (BOXES * end) / count;
  }
  const most = 2 * Math.max(count, 1);
  const bounds = new Float32Array(6 * most);
  const child = new Int32Array(most);
  const leafCount = new Uint8Array(most);
  let used = 1;
  let since = 0;
  let [spent, left] = [0, workOf(Math.max(count, 1))];
  const progress = (): number => BOXES + (1 - BOXES) * (spent / (spent + left));
  const todo = [{ node: 0, start: 0, end: count }];
  for (let task = todo.pop(); task; task = todo.pop()) {
    const { node, start, end } = task;
    splitter.begin(start, end);
    while (splitter.measure(CHUNK)) yield progress();
    splitter.writeBox(bounds, 6 * node);
    if (end - start <= MOST_IN_LEAF) {
      child[node] = start;
      leafCount[node] = end - start;
      left -= workOf(end - start);
    } else {
      while (splitter.fillBins(CHUNK)) yield progress();
      splitter.chooseBorder();
      while (splitter.part(CHUNK)) yield progress();
      const { middle } = splitter;
      child[node] = used;
      todo.push({ node: used, start, end: middle }, { node: used + 1, start: middle, end });
      used += 2;
      left += workOf(middle - start) + workOf(end - middle) - workOf(end - start);
    }
    spent += end - start;
    since += end - start;
    if (since < CHUNK) continue;
    since = 0;
    yield progress();
  }
  return {
    bounds: bounds.slice(0, 6 * used),
    child: child.slice(0, used),
    leafCount: leafCount.slice(0, used),
    order: splitter.order,
  };
}
