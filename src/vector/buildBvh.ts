/** Number of bins, and the number for small ranges. */
const BINS = 16;
const FEW_BINS = 6;
const FEW = 64;
/** Numbers of a box: its least corner, and its greatest. */
const BOX = 6;
/** Relative and absolute bounds of the rounding error of a `Float32Array`. */
const ROUNDED_BY = 1.2e-7;
const LEAST = 1e-37;

/** Splits ranges of triangles for a bounding volume hierarchy, in steps of a bounded number of triangles. */
export class TriangleSplitter {
  /** Triangle indices, partitioned by the splits. */
  readonly order: Uint32Array;
  /** The start of the second part of the current range, once it is split. */
  middle = 0;
  /** A box per triangle in that order, slightly larger than the triangle. */
  private readonly boxes: Float32Array;
  private start = 0;
  private end = 0;
  /** Progress of the current step, and the start of the second part so far. */
  private at = 0;
  private upTo = 0;
  /** The box of the range, and the box of the doubled centres of its boxes. */
  private readonly own = new Float64Array(BOX);
  private readonly centres = new Float64Array(BOX);
  private readonly counts = new Uint32Array(BINS);
  private readonly bins = new Float64Array(BOX * BINS);
  private readonly costs = new Float64Array(BINS);
  /** The binning: axis, number of bins, start of the first, and bins per unit. */
  private axis = 0;
  private binCount = BINS;
  private origin = 0;
  private perUnit = 0;
  /** The first bin of the second part; −1 if all triangles are in one bin. */
  private border = -1;

  constructor(count: number) {
    this.order = new Uint32Array(count);
    this.boxes = new Float32Array(BOX * count);
  }

  /** Computes the boxes of triangles: nine numbers each. */
  readBoxes(corners: Float64Array, start: number, end: number): void {
    const { order, boxes } = this;
    for (let t = start; t < end; t++) {
      order[t] = t;
      for (let a = 0; a < 3; a++) {
        const [p, q, r] = [corners[9 * t + a], corners[9 * t + 3 + a], corners[9 * t + 6 + a]];
        const least = Math.min(p, q, r);
        const most = Math.max(p, q, r);
        boxes[BOX * t + a] = least - ROUNDED_BY * Math.abs(least) - LEAST;
        boxes[BOX * t + 3 + a] = most + ROUNDED_BY * Math.abs(most) + LEAST;
      }
    }
  }

  /** Begins to split a range. */
  begin(start: number, end: number): void {
    this.start = this.at = start;
    this.end = end;
    empty(this.own, 0);
    empty(this.centres, 0);
  }

  /** Computes the box of the range, so many triangles at a time. Returns whether there is more to do. */
  measure(step: number): boolean {
    const { boxes, own, centres } = this;
    const end = Math.min(this.at + step, this.end);
    for (let o = BOX * this.at; o < BOX * end; o += BOX) {
      for (let a = 0; a < 3; a++) {
        const least = boxes[o + a];
        const most = boxes[o + 3 + a];
        const centre = least + most;
        if (least < own[a]) own[a] = least;
        if (most > own[3 + a]) own[3 + a] = most;
        if (centre < centres[a]) centres[a] = centre;
        if (centre > centres[3 + a]) centres[3 + a] = centre;
      }
    }
    this.at = end;
    if (end < this.end) return true;
    this.layBins();
    return false;
  }

  writeBox(bounds: Float32Array, offset: number): void {
    for (let a = 0; a < BOX; a++) bounds[offset + a] = this.own[a];
  }

  private layBins(): void {
    const { centres, counts, bins } = this;
    const extent = (a: number): number => centres[3 + a] - centres[a];
    this.axis = extent(1) > extent(0) ? 1 : 0;
    if (extent(2) > extent(this.axis)) this.axis = 2;
    this.origin = centres[this.axis];
    this.binCount = this.end - this.start < FEW ? FEW_BINS : BINS;
    this.perUnit = this.binCount / extent(this.axis);
    for (let bin = 0; bin < this.binCount; bin++) {
      counts[bin] = 0;
      empty(bins, BOX * bin);
    }
    this.at = this.start;
  }

  /** Ranges without extent, and NaN, go to the first bin. */
  private binOf(o: number): number {
    const { boxes, axis } = this;
    const bin = (boxes[o + axis] + boxes[o + 3 + axis] - this.origin) * this.perUnit;
    return bin > 0 ? Math.min(bin | 0, this.binCount - 1) : 0;
  }

  /** Fills the bins, so many triangles at a time. Returns whether there is more to do. */
  fillBins(step: number): boolean {
    const { boxes, bins, counts } = this;
    const end = Math.min(this.at + step, this.end);
    for (let o = BOX * this.at; o < BOX * end; o += BOX) {
      const bin = this.binOf(o);
      counts[bin]++;
      grow(bins, BOX * bin, boxes, o);
    }
    this.at = end;
    return end < this.end;
  }

  /** Chooses the border between bins that makes rays cheapest. */
  chooseBorder(): void {
    const { costs, counts, bins, own, binCount } = this;
    empty(own, 0);
    for (let bin = 0, sum = 0; bin < binCount - 1; bin++) {
      grow(own, 0, bins, BOX * bin);
      sum += counts[bin];
      costs[bin + 1] = sum === 0 ? Infinity : sum * areaOf(own);
    }
    empty(own, 0);
    this.border = -1;
    let least = Infinity;
    for (let bin = binCount - 1, sum = 0; bin > 0; bin--) {
      grow(own, 0, bins, BOX * bin);
      sum += counts[bin];
      const cost = sum === 0 ? Infinity : costs[bin] + sum * areaOf(own);
      if (cost >= least) continue;
      least = cost;
      this.border = bin;
    }
    this.at = this.start;
    this.upTo = this.end;
  }

  /** Moves the triangles of the first part to the front, so many at a time. Returns whether there is more to do. */
  part(step: number): boolean {
    const { border, start, end } = this;
    let { at, upTo } = this;
    for (let i = 0; at < upTo && border >= 0; i++) {
      if (i === step) {
        this.at = at;
        this.upTo = upTo;
        return true;
      }
      if (this.binOf(BOX * at) < border) at++;
      else this.swap(at, --upTo);
    }
    this.middle = at > start && at < end ? at : (start + end) >> 1;
    return false;
  }

  private swap(i: number, j: number): void {
    const { order, boxes } = this;
    const triangle = order[i];
    order[i] = order[j];
    order[j] = triangle;
    for (let k = 0; k < BOX; k++) {
      const number = boxes[BOX * i + k];
      boxes[BOX * i + k] = boxes[BOX * j + k];
      boxes[BOX * j + k] = number;
    }
  }
}

function empty(boxes: Float64Array, o: number): void {
  for (let a = 0; a < 3; a++) {
    boxes[o + a] = Infinity;
    boxes[o + 3 + a] = -Infinity;
  }
}

function grow(boxes: Float64Array, o: number, others: Float64Array | Float32Array, other: number): void {
  for (let a = 0; a < 3; a++) {
    const least = others[other + a];
    const most = others[other + 3 + a];
    if (least < boxes[o + a]) boxes[o + a] = least;
    if (most > boxes[o + 3 + a]) boxes[o + 3 + a] = most;
  }
}

function areaOf(box: Float64Array): number {
  const x = box[3] - box[0];
  const y = box[4] - box[1];
  const z = box[5] - box[2];
  return x >= 0 ? x * y + y * z + z * x : 0;
}

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
