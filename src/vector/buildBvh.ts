/** A hierarchy of boxes around triangles, as flat arrays. */
export interface BvhNodes {
  /** Six numbers per node: the least corner of its box, and the greatest. */
  bounds: Float64Array;
  /** Of an inner node its left child, which the right one follows; of a leaf its first triangle in `order`. */
  child: Int32Array;
  /** The number of triangles of a leaf; 0 for inner nodes. */
  leafCount: Uint32Array;
  /** Triangles in the order of the leaves. */
  order: Uint32Array;
}

const BINS = 16;
const MOST_IN_LEAF = 4;

/** Builds the hierarchy: boxes are split where the surface area heuristic, over bins, finds it cheapest. Yields its progress. */
export function* buildBvh(corners: Float64Array): Generator<number, BvhNodes, void> {
  const count = corners.length / 9;
  const boxes = boxesOf(corners);
  const nodes: BvhNodes = {
    bounds: new Float64Array(12 * Math.max(count, 1)),
    child: new Int32Array(2 * Math.max(count, 1)),
    leafCount: new Uint32Array(2 * Math.max(count, 1)),
    order: Uint32Array.from({ length: count }, (_, i) => i),
  };
  let used = 1;
  let done = 0;
  let since = 0;
  const todo = [{ node: 0, start: 0, end: count }];
  for (let task = todo.pop(); task; task = todo.pop()) {
    const { node, start, end } = task;
    const middle = splitRange(nodes, boxes, node, start, end);
    if (middle < 0) {
      nodes.child[node] = start;
      nodes.leafCount[node] = end - start;
      done += end - start;
    } else {
      nodes.child[node] = used;
      todo.push({ node: used, start, end: middle }, { node: used + 1, start: middle, end });
      used += 2;
    }
    since += end - start;
    if (since < 1 << 14) continue;
    since = 0;
    yield done / count;
  }
  return nodes;
}

/** The box of each triangle. */
function boxesOf(corners: Float64Array): Float64Array {
  const boxes = new Float64Array((6 * corners.length) / 9);
  for (let t = 0; 9 * t < corners.length; t++) {
    for (let a = 0; a < 3; a++) {
      const [p, q, r] = [corners[9 * t + a], corners[9 * t + 3 + a], corners[9 * t + 6 + a]];
      boxes[6 * t + a] = Math.min(p, q, r);
      boxes[6 * t + 3 + a] = Math.max(p, q, r);
    }
  }
  return boxes;
}

/** Writes the box of a node and sorts its triangles into two. Returns where the second begins, or −1 for a leaf. */
function splitRange(nodes: BvhNodes, boxes: Float64Array, node: number, start: number, end: number): number {
  const { order, bounds } = nodes;
  const own = emptyBox();
  const centres = emptyBox();
  for (let i = start; i < end; i++) {
    const box = 6 * order[i];
    for (let a = 0; a < 3; a++) {
      own[a] = Math.min(own[a], boxes[box + a]);
      own[3 + a] = Math.max(own[3 + a], boxes[box + 3 + a]);
      const centre = boxes[box + a] + boxes[box + 3 + a];
      centres[a] = Math.min(centres[a], centre);
      centres[3 + a] = Math.max(centres[3 + a], centre);
    }
  }
  bounds.set(own, 6 * node);
  if (end - start <= MOST_IN_LEAF) return -1;
  let axis = 0;
  for (let a = 1; a < 3; a++) if (centres[3 + a] - centres[a] > centres[3 + axis] - centres[axis]) axis = a;
  const extent = centres[3 + axis] - centres[axis];
  const half = (start + end) >> 1;
  if (!(extent > 0)) return half;
  const binOf = (t: number): number =>
    Math.min(BINS - 1, Math.floor(((boxes[6 * t + axis] + boxes[6 * t + 3 + axis] - centres[axis]) * BINS) / extent));
  const border = cheapestBin(order, boxes, binOf, start, end);
  const middle = border < 0 ? half : partition(order, (t) => binOf(t) < border, start, end);
  return middle > start && middle < end ? middle : half;
}

const emptyBox = (): Float64Array => Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);

function grow(box: Float64Array, others: Float64Array, offset: number): void {
  for (let a = 0; a < 3; a++) {
    box[a] = Math.min(box[a], others[offset + a]);
    box[3 + a] = Math.max(box[3 + a], others[offset + 3 + a]);
  }
}

function areaOf(box: Float64Array): number {
  const [x, y, z] = [box[3] - box[0], box[4] - box[1], box[5] - box[2]];
  return x >= 0 ? x * y + y * z + z * x : 0;
}

/** The bin that the second half begins with; −1 if all lie in one. */
function cheapestBin(
  order: Uint32Array,
  boxes: Float64Array,
  binOf: (triangle: number) => number,
  start: number,
  end: number,
): number {
  const counts = new Uint32Array(BINS);
  const bins = Array.from({ length: BINS }, emptyBox);
  for (let i = start; i < end; i++) {
    const bin = binOf(order[i]);
    counts[bin]++;
    grow(bins[bin], boxes, 6 * order[i]);
  }
  const costs = new Float64Array(BINS);
  let box = emptyBox();
  for (let bin = 0, sum = 0; bin < BINS - 1; bin++) {
    grow(box, bins[bin], 0);
    sum += counts[bin];
    costs[bin + 1] = sum === 0 ? Infinity : sum * areaOf(box);
  }
  box = emptyBox();
  let best = -1;
  let least = Infinity;
  for (let bin = BINS - 1, sum = 0; bin > 0; bin--) {
    grow(box, bins[bin], 0);
    sum += counts[bin];
    const cost = sum === 0 ? Infinity : costs[bin] + sum * areaOf(box);
    if (cost >= least) continue;
    least = cost;
    best = bin;
  }
  return best;
}

/** Moves those that belong to the first half to the front. Returns where the others begin. */
function partition(order: Uint32Array, isFirst: (triangle: number) => boolean, start: number, end: number): number {
  let i = start;
  let j = end - 1;
  while (i <= j) {
    if (isFirst(order[i])) i++;
    else {
      [order[i], order[j]] = [order[j], order[i]];
      j--;
    }
  }
  return i;
}
