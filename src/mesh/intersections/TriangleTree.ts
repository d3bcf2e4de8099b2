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
    this.order = Uint32Array.from({ length: count }, (_, i) => i);
    this.boxes = new Float64Array(BOX * Math.max(2 * count, 1));
    this.firsts = new Int32Array(Math.max(2 * count, 1));
    this.counts = new Int32Array(this.firsts.length);
    this.shells = new Int32Array(this.firsts.length);
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
      const [first, count] = [-1 - firsts[node], counts[node]];
      if (count <= LEAF) continue;
      sorted += count;
      if (sorted > 1 << 14) {
        sorted = 0;
        yield 0.5;
      }
      const b = BOX * node;
      const sizes = [0, 1, 2].map((axis) => boxes[b + 3 + axis] - boxes[b + axis]);
      const axis = sizes.indexOf(Math.max(...sizes));
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
    const target = BOX * node;
    for (let axis = 0; axis < 3; axis++) {
      boxes[target + axis] = Infinity;
      boxes[target + 3 + axis] = -Infinity;
    }
    shells[node] = count > 0 ? shellOf[order[first]] : MIXED;
    for (let i = first; i < first + count; i++) {
      const triangle = order[i];
      const source = BOX * triangle;
      for (let axis = 0; axis < 3; axis++) {
        boxes[target + axis] = Math.min(boxes[target + axis], triangleBoxes[source + axis]);
        boxes[target + 3 + axis] = Math.max(boxes[target + 3 + axis], triangleBoxes[source + 3 + axis]);
      }
      if (shellOf[triangle] !== shells[node]) shells[node] = MIXED;
    }
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
