import { asPhase } from '../../mesh/phases.js';

/** Start and end of a path; any unit of length. */
export interface PathEnds {
  start: readonly [number, number];
  end: readonly [number, number];
}

/** A path in the order of drawing, perhaps reversed. */
export interface OrderedPath {
  path: number;
  isReversed: boolean;
}

/** Both ends of each path: x and y in turn. */
export const pointsOf = (paths: readonly PathEnds[]): Float64Array =>
  Float64Array.from(paths.flatMap(({ start, end }) => [...start, ...end]));

/** Number of nearest ends that are tried for each end. */
const NEIGHBOURS = 10;
/** Longest stretch that is moved. */
const LONGEST_MOVED = 3;
/** Smaller gains are rounding errors. */
const LEAST_GAIN = 1e-9;
/** Longest stretch that is exchanged at random. */
const LONGEST_EXCHANGED = 12;

/**
 * Shortens the travel of the lifted pen: stretches of an order are reversed (2-opt, Croes, 1958) or moved (Or, 1976) where an end then
 * follows one of its nearest. When nothing improves, random exchanges continue the search (iterated local search, Martin, Otto and Felten,
 * 1991). Changes the order. Yields its progress.
 */
export function* improveOrder(paths: readonly PathEnds[], order: OrderedPath[]): Generator<number, void, void> {
  if (order.length < 3) return;
  const points = pointsOf(paths);
  const nearest = yield* nearestEnds(points, Math.min(NEIGHBOURS, 2 * paths.length - 2));
  const search = new Search(points, nearest, order);
  yield* asPhase(search.settle(), 0, 0.3);
  for (let trial = 0; trial < paths.length; trial++) {
    if (trial % 16 === 15) yield 0.3 + (0.7 * trial) / paths.length;
    search.tryExchange();
  }
  search.writeTo(order);
}

/** A local search. An end has the index of its path times two, plus one for the second end. */
class Search {
  private readonly places: Int32Array;
  /** The first end of each path in the order. */
  private readonly begun: Int32Array;
  private readonly count: number;
  /** Paths whose ends are to be tried, and whether each is queued. */
  private readonly queue: number[] = [];
  private readonly isQueued: Uint8Array;
  /** The stretches that were reversed since a trial began: first and last of each. */
  private readonly turns: number[] = [];
  private chance = 1;

  constructor(
    private readonly points: Float64Array,
    private readonly nearest: Int32Array,
    order: readonly OrderedPath[],
  ) {
    this.count = (2 * nearest.length) / points.length;
    this.places = new Int32Array(order.length);
    this.begun = Int32Array.from(order, ({ path, isReversed }) => 2 * path + Number(isReversed));
    this.isQueued = new Uint8Array(order.length);
    for (let i = order.length - 1; i >= 0; i--) {
      this.places[this.begun[i] >> 1] = i;
      this.lookAt(i);
    }
  }

  /** Improves the order until nothing is gained. Yields its progress. */
  *settle(): Generator<number, void, void> {
    for (let done = 0; this.queue.length > 0; done++) {
      if (done % 32 === 31) yield done / (done + this.queue.length);
      this.improveNext();
    }
    this.turns.length = 0;
  }

  /** Exchanges two neighbouring stretches at random, improves the result, and reverts everything unless it is a gain. */
  tryExchange(): void {
    const count = this.begun.length;
    const longest = Math.min(LONGEST_EXCHANGED, count >> 1);
    const a = this.hash(count - 1);
    const b = Math.min(a + this.hash(longest), count - 2);
    const c = Math.min(b + 1 + this.hash(longest), count - 1);
    const [before, after] = [this.to(a - 1), this.from(c + 1)];
    let gain =
      this.way(before, this.from(a)) +
      this.way(this.to(b), this.from(b + 1)) +
      this.way(this.to(c), after) -
      this.way(before, this.from(b + 1)) -
      this.way(this.to(c), this.from(a)) -
      this.way(this.to(b), after);
    this.exchange(a, b, c);
    while (this.queue.length > 0) gain += this.improveNext();
    if (gain < 0) for (let i = this.turns.length - 2; i >= 0; i -= 2) this.turn(this.turns[i], this.turns[i + 1]);
    this.turns.length = 0;
  }

  /** A pseudorandom integer below a limit (Lehmer, 1951). */
  private hash(below: number): number {
    this.chance = (48271 * this.chance) % 0x7fffffff;
    return this.chance % below;
  }

  private improveNext(): number {
    const path = this.queue.pop()!;
    this.isQueued[path] = 0;
    const gain = this.improve(path);
    if (gain > 0) this.lookAt(this.places[path]);
    return gain;
  }

  /** Queues the path at a position of the order. */
  private lookAt(i: number): void {
    if (i < 0 || i >= this.begun.length) return;
    const path = this.begun[i] >> 1;
    if (this.isQueued[path] === 1) return;
    this.isQueued[path] = 1;
    this.queue.push(path);
  }

  writeTo(order: OrderedPath[]): void {
    for (const [i, end] of this.begun.entries()) order[i] = { path: end >> 1, isReversed: (end & 1) === 1 };
  }

  /** Makes the first change at either end of a path, reversing or moving it, that shortens the travel. Returns the gain. */
  private improve(path: number): number {
    for (let end = 2 * path; end <= 2 * path + 1; end++) {
      const i = this.places[path];
      const way = end === this.to(i) ? this.way(end, this.from(i + 1)) : this.way(this.to(i - 1), end);
      for (let k = 0; k < this.count; k++) {
        const other = this.nearest[end * this.count + k];
        // Leaving a nearer end for a farther one hardly ever pays.
        const joined = other < 0 ? Infinity : this.way(end, other);
        if (joined >= way) break;
        const gain = this.reverse(end, other) || this.move(end, other, joined);
        if (gain > 0) return gain;
      }
    }
    return 0;
  }

  /** The end at which the path at a position of the order is begun or left; −1 beyond both ends of the order. */
  private from(i: number): number {
    return i >= this.begun.length ? -1 : this.begun[i];
  }

  private to(i: number): number {
    return i < 0 ? -1 : this.begun[i] ^ 1;
  }

  /** The travel from one end to another: from the corner of the sheet to the first, and none after the last. */
  private way(leaving: number, reaching: number): number {
    if (reaching < 0) return 0;
    const { points } = this;
    const dx = points[2 * reaching] - (leaving < 0 ? 0 : points[2 * leaving]);
    const dy = points[2 * reaching + 1] - (leaving < 0 ? 0 : points[2 * leaving + 1]);
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Reverses a stretch so that one end follows another. Returns the gain, 0 if there is none. */
  private reverse(end: number, other: number): number {
    const [i, j] = [this.places[end >> 1], this.places[other >> 1]];
    const isLeft = end === this.to(i);
    if (isLeft !== (other === this.to(j))) return 0;
    // The stretch lies between both paths or includes them: after the one that is left first, or before the one that is begun last.
    const first = isLeft ? Math.min(i, j) + 1 : Math.min(i, j);
    const last = isLeft ? Math.max(i, j) : Math.max(i, j) - 1;
    const before = this.to(first - 1);
    const after = this.from(last + 1);
    const old = this.way(before, this.from(first)) + this.way(this.to(last), after);
    const gain = old - this.way(before, this.to(last)) - this.way(this.from(first), after);
    if (gain < LEAST_GAIN) return 0;
    this.reverseStretch(first, last);
    return gain;
  }

  /** Moves a short stretch with an end to where another is, so far away. Returns the gain, 0 if there is none. */
  private move(end: number, other: number, joined: number): number {
    const i = this.places[end >> 1];
    const j = this.places[other >> 1];
    const isLeft = end === this.to(i);
    const isAfter = other === this.to(j);
    // The position in the order that it is moved behind.
    const after = isAfter ? j : j - 1;
    const beyond = isAfter ? this.from(j + 1) : this.to(j - 1);
    const opened = (isAfter ? this.way(other, beyond) : this.way(beyond, other)) - joined;
    for (let length = 1; length <= LONGEST_MOVED; length++) {
      const a = isLeft ? i - length + 1 : i;
      const b = isLeft ? i : i + length - 1;
      if (a < 0 || b >= this.begun.length || (j >= a && j <= b)) break;
      if (after === a - 1 || after === b) continue;
      const before = this.to(a - 1);
      const next = this.from(b + 1);
      const saved = this.way(before, this.from(a)) + this.way(this.to(b), next) - this.way(before, next);
      if (saved + opened < LEAST_GAIN) continue;
      // The other end of the stretch.
      const tail = isLeft ? this.from(a) : this.to(b);
      const gain = saved + opened - (isAfter ? this.way(tail, beyond) : this.way(beyond, tail));
      if (gain < LEAST_GAIN) continue;
      this.moveAfter(a, b, after, isLeft === isAfter);
      return gain;
    }
    return 0;
  }

  /** Reverses a stretch. */
  private reverseStretch(first: number, last: number): void {
    this.turns.push(first, last);
    this.turn(first, last);
    this.lookAt(first - 1);
    this.lookAt(first);
    this.lookAt(last);
    this.lookAt(last + 1);
  }

  private turn(first: number, last: number): void {
    const { begun, places } = this;
    for (let i = first, j = last; i <= j; i++, j--) {
      const one = begun[i] ^ 1;
      begun[i] = begun[j] ^ 1;
      begun[j] = one;
      places[begun[i] >> 1] = i;
      places[one >> 1] = j;
    }
  }

  /** Exchanges the stretches from a to b and from b to c. */
  private exchange(a: number, b: number, c: number): void {
    this.reverseStretch(a, c);
    const middle = a + c - b;
    this.reverseStretch(a, middle - 1);
    this.reverseStretch(middle, c);
  }

  private moveAfter(a: number, b: number, after: number, isTurned: boolean): void {
    if (isTurned) this.reverseStretch(a, b);
    if (after < a) this.exchange(after + 1, a - 1, b);
    else this.exchange(a, b, after);
  }
}

/**
 * The nearest neighbours of each point, except the other point of its pair. A grid makes it nearly linear in time. Yields its progress.
 *
 * @param points x and y in turn; points 0 and 1 are a pair, and 2 and 3 …
 * @param count number of neighbours
 * @returns `count` indices per point, nearest first; −1 for none
 */
function* nearestEnds(points: Float64Array, count: number): Generator<number, Int32Array, void> {
  const total = points.length / 2;
  const nearest = new Int32Array(total * count).fill(-1);
  const grid = new Grid(points);
  const distances = new Float64Array(count);
  for (let p = 0; p < total; p++) {
    if (p % 64 === 63) yield p / total;
    let found = 0;
    const [x, y] = [points[2 * p], points[2 * p + 1]];
    const add = (q: number): void => {
      if (q >> 1 === p >> 1) return;
      const [dx, dy] = [points[2 * q] - x, points[2 * q + 1] - y];
      const away = Math.sqrt(dx * dx + dy * dy);
      if (found === count && away >= distances[count - 1]) return;
      let i = found < count ? found++ : count - 1;
      for (; i > 0 && distances[i - 1] > away; i--) {
        distances[i] = distances[i - 1];
        nearest[p * count + i] = nearest[p * count + i - 1];
      }
      distances[i] = away;
      nearest[p * count + i] = q;
    };
    for (let ring = 0; ring < grid.columns; ring++) {
      // Points in rings farther out are at least this far away.
      if (found === count && (ring - 1) * grid.size > distances[count - 1]) break;
      grid.visitRing(x, y, ring, (cell) => cell.forEach(add));
    }
  }
  return nearest;
}

/** Points in the cells of a square grid. */
export class Grid {
  readonly columns: number;
  readonly size: number;
  private readonly left: number;
  private readonly top: number;
  private readonly cells: number[][];

  /** @param points x and y in turn, two points for each path */
  constructor(points: Float64Array) {
    let [right, bottom] = [-Infinity, -Infinity];
    let [left, top] = [Infinity, Infinity];
    for (let i = 0; i < points.length; i += 2) {
      [left, right] = [Math.min(left, points[i]), Math.max(right, points[i])];
      [top, bottom] = [Math.min(top, points[i + 1]), Math.max(bottom, points[i + 1])];
    }
    [this.left, this.top] = [left, top];
    const count = Math.max(1, Math.ceil(Math.sqrt(points.length / 4)));
    this.columns = count + 1;
    this.size = Math.max(right - left, bottom - top, 1e-9) / count;
    this.cells = Array.from({ length: this.columns ** 2 }, () => []);
    for (let p = 0; 2 * p < points.length; p++) {
      const [column, row] = this.cellOf(points[2 * p], points[2 * p + 1]);
      this.cells[column + this.columns * row].push(p);
    }
  }

  /** The cell of a position, or the nearest one. */
  private cellOf(x: number, y: number): readonly [column: number, row: number] {
    const at = (distance: number) => Math.min(this.columns - 1, Math.max(0, Math.floor(distance / this.size)));
    return [at(x - this.left), at(y - this.top)];
  }

  /** Calls back for the cells in a ring around that of a position. */
  visitRing(x: number, y: number, ring: number, call: (cell: number[]) => void): void {
    const { columns } = this;
    const [column, row] = this.cellOf(x, y);
    for (let r = Math.max(row - ring, 0); r <= Math.min(row + ring, columns - 1); r++) {
      const step = Math.abs(r - row) === ring || ring === 0 ? 1 : 2 * ring;
      for (let c = column - ring; c <= column + ring; c += step)
        if (c >= 0 && c < columns) call(this.cells[c + columns * r]);
    }
  }
}
