/** Triangles of a leaf, at most. */
const LEAF = 4;
/** Numbers of a box: its least x, y, z and its greatest. */
export const BOX = 6;
/** The shell of a node whose triangles are of several. */
export const MIXED = -1;

/** A tree of boxes around triangles. */
export class TriangleTree {
  /** Six numbers per node. */
  readonly boxes: Float64Array;
  /** The first child of an inner node, whose other child follows it; for a leaf −1 − its first triangle in `order`. */
  readonly firsts: Int32Array;
  /** Triangles of a node. */
  readonly counts: Int32Array;
  /** The sum of the sides of the box of a node. */
  readonly sizes: Float64Array;
  /** The shell that all triangles of a node belong to, or `MIXED`. */
  readonly shells: Int32Array;
  /** All triangles, those of a node in a row. */
  readonly order: Uint32Array;

  private constructor(
    /** Six numbers per triangle. */
    readonly triangleBoxes: Float64Array,
    private readonly shellOf: ArrayLike<number>,
  ) {
    const count = triangleBoxes.length / BOX;
    this.order = new Uint32Array(count);
    for (let i = 0; i < count; i++) this.order[i] = i;
    this.boxes = new Float64Array(BOX * Math.max(2 * count, 1));
    this.firsts = new Int32Array(Math.max(2 * count, 1));
    this.counts = new Int32Array(this.firsts.length);
    this.shells = new Int32Array(this.firsts.length);
    this.sizes = new Float64Array(this.firsts.length);
  }

  /**
   * Builds a tree. Yields its progress.
   *
   * @param triangleBoxes six numbers per triangle
   * @param shellOf the shell of each triangle
   */
  static *build(triangleBoxes: Float64Array, shellOf: ArrayLike<number>): Generator<number, TriangleTree, void> {
    const tree = new TriangleTree(triangleBoxes, shellOf);
    yield* tree.split();
    return tree;
  }

  private *split(): Generator<number, void, void> {
    const { order, firsts, counts, boxes } = this;
    let nodes = 1;
    let sorted = 0;
    this.setLeaf(0, 0, order.length);
    const waiting = [0];
    for (let node = waiting.pop(); node !== undefined; node = waiting.pop()) {
      const first = -1 - firsts[node];
      const count = counts[node];
      if (count <= LEAF) continue;
      sorted += count;
      if (sorted > 1 << 14) {
        sorted = 0;
        yield 0.5;
      }
      const b = BOX * node;
      const x = boxes[b + 3] - boxes[b];
      const y = boxes[b + 4] - boxes[b + 1];
      const z = boxes[b + 5] - boxes[b + 2];
      const axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
      const middle = this.partition(first, count, axis, boxes[b + axis] + boxes[b + 3 + axis]);
      firsts[node] = nodes;
      this.setLeaf(nodes, first, middle - first);
      this.setLeaf(nodes + 1, middle, first + count - middle);
      waiting.push(nodes, nodes + 1);
      nodes += 2;
    }
  }

  /** Moves the triangles whose centre lies below a plane to the front. @param twice twice its coordinate. Returns the first of the others. */
  private partition(first: number, count: number, axis: number, twice: number): number {
    const { order, triangleBoxes } = this;
    let low = first;
    for (let i = first; i < first + count; i++) {
      const b = BOX * order[i];
      if (triangleBoxes[b + axis] + triangleBoxes[b + 3 + axis] >= twice) continue;
      const moved = order[low];
      order[low++] = order[i];
      order[i] = moved;
    }
    // A crowd on one side is halved, whatever its places.
    return low - first < count / 64 || low - first > (63 * count) / 64 ? first + (count >> 1) : low;
  }

  private setLeaf(node: number, first: number, count: number): void {
    const { boxes, order, triangleBoxes, shellOf, shells } = this;
    this.firsts[node] = -1 - first;
    this.counts[node] = count;
    let [x0, y0, z0, x1, y1, z1] = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    let shell = count > 0 ? shellOf[order[first]] : MIXED;
    for (let i = first; i < first + count; i++) {
      const s = BOX * order[i];
      if (triangleBoxes[s] < x0) x0 = triangleBoxes[s];
      if (triangleBoxes[s + 1] < y0) y0 = triangleBoxes[s + 1];
      if (triangleBoxes[s + 2] < z0) z0 = triangleBoxes[s + 2];
      if (triangleBoxes[s + 3] > x1) x1 = triangleBoxes[s + 3];
      if (triangleBoxes[s + 4] > y1) y1 = triangleBoxes[s + 4];
      if (triangleBoxes[s + 5] > z1) z1 = triangleBoxes[s + 5];
      if (shellOf[order[i]] !== shell) shell = MIXED;
    }
    const t = BOX * node;
    boxes[t] = x0;
    boxes[t + 1] = y0;
    boxes[t + 2] = z0;
    boxes[t + 3] = x1;
    boxes[t + 4] = y1;
    boxes[t + 5] = z1;
    shells[node] = shell;
    this.sizes[node] = x1 - x0 + (y1 - y0) + (z1 - z0);
  }
}

/** Whether two boxes have a place in common, or touch. */
export function boxesMeet(a: Float64Array, i: number, b: Float64Array, j: number): boolean {
  return (
    a[i] <= b[j + 3] &&
    b[j] <= a[i + 3] &&
    a[i + 1] <= b[j + 4] &&
    b[j + 1] <= a[i + 4] &&
    a[i + 2] <= b[j + 5] &&
    b[j + 2] <= a[i + 5]
  );
}
