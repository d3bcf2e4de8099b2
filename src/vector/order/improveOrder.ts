import { nearestEnds } from './nearestEnds.js';
import type { OrderedPath, PathEnds } from './PathEnds.js';

/** Ends are joined with so many of the nearest to them. */
const NEIGHBOURS = 10;
/** Stretches of so many paths are moved to another place. */
const LONGEST_MOVED = 3;
const PASSES = 40;
/** So many times as far as now an end may have to the one that it is joined with. */
const FARTHER = 2.5;
/** A gain below this is a rounding. */
const LEAST_GAIN = 1e-9;

/**
 * Shortens the way of the lifted pen: stretches of an order are reversed (2-opt, Croes, 1958) or moved (Or, 1976) wherever an end then
 * follows one of the nearest to it. Changes the order. Yields its progress.
 */
export function* improveOrder(paths: readonly PathEnds[], order: OrderedPath[]): Generator<number, void, void> {
  if (order.length < 3) return;
  const points = Float64Array.from(paths.flatMap(({ start, end }) => [...start, ...end]));
  const nearest = yield* nearestEnds(points, Math.min(NEIGHBOURS, 2 * paths.length - 2));
  const search = new Search(points, nearest, order);
  for (let pass = 0; pass < PASSES; pass++) {
    let gained = 0;
    for (let path = 0; path < paths.length; path++) {
      if (path % 32 === 31) yield pass / PASSES;
      gained += search.improve(path);
    }
    if (gained < LEAST_GAIN) break;
  }
  search.writeTo(order);
}

/** An end is twice the number of its path, plus one for the second. */
class Search {
  private readonly places: Int32Array;
  /** The end that each path in the order is begun at. */
  private readonly begun: Int32Array;
  private readonly count: number;

  constructor(
    private readonly points: Float64Array,
    private readonly nearest: Int32Array,
    order: readonly OrderedPath[],
  ) {
    this.count = (2 * nearest.length) / points.length;
    this.places = new Int32Array(order.length);
    this.begun = Int32Array.from(order, ({ path, isReversed }) => 2 * path + Number(isReversed));
    this.note(0, order.length - 1);
  }

  writeTo(order: OrderedPath[]): void {
    for (const [i, end] of this.begun.entries()) order[i] = { path: end >> 1, isReversed: (end & 1) === 1 };
  }

  /** Does the first change at either end of a path, or with it moved, that shortens the way. Returns by how much. */
  improve(path: number): number {
    for (const end of [2 * path, 2 * path + 1]) {
      const i = this.places[path];
      const way = end === this.to(i) ? this.way(end, this.from(i + 1)) : this.way(this.to(i - 1), end);
      for (let k = 0; k < this.count; k++) {
        const other = this.nearest[end * this.count + k];
        // An end that is left for one much farther away hardly ever pays.
        if (other < 0 || this.way(end, other) > FARTHER * way) break;
        const gain = this.reverse(end, other) || this.move(end, other);
        if (gain > 0) return gain;
      }
    }
    return 0;
  }

  /** The end that the path at a place in the order is begun or left at; −1 beyond both ends. */
  private from(i: number): number {
    return i >= this.begun.length ? -1 : this.begun[i];
  }

  private to(i: number): number {
    return i < 0 ? -1 : this.begun[i] ^ 1;
  }

  /** The way from one end to another; from the corner of the sheet to the first, and none after the last. */
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
    // Between both, or with both: the stretch after the one that is left first, or before the one that is begun last.
    const [first, last] = isLeft ? [Math.min(i, j) + 1, Math.max(i, j)] : [Math.min(i, j), Math.max(i, j) - 1];
    const before = this.to(first - 1);
    const after = this.from(last + 1);
    const old = this.way(before, this.from(first)) + this.way(this.to(last), after);
    const gain = old - this.way(before, this.to(last)) - this.way(this.from(first), after);
    if (gain < LEAST_GAIN) return 0;
    this.turn(first, last);
    return gain;
  }

  /** Moves a short stretch with an end to where another is. Returns the gain, 0 if there is none. */
  private move(end: number, other: number): number {
    const [i, j] = [this.places[end >> 1], this.places[other >> 1]];
    const isLeft = end === this.to(i);
    for (let length = 1; length <= LONGEST_MOVED; length++) {
      const [a, b] = isLeft ? [i - length + 1, i] : [i, i + length - 1];
      if (a < 0 || b >= this.begun.length || (j >= a && j <= b)) continue;
      // The place in the order after which it comes.
      const after = other === this.to(j) ? j : j - 1;
      if (after === a - 1 || after === b) continue;
      const isTurned = isLeft === (other === this.to(j));
      const [head, tail] = isTurned ? [this.to(b), this.from(a)] : [this.from(a), this.to(b)];
      const [left, right] = [this.to(after), this.from(after + 1)];
      const saved =
        this.way(this.to(a - 1), this.from(a)) +
        this.way(this.to(b), this.from(b + 1)) -
        this.way(this.to(a - 1), this.from(b + 1));
      const gain = saved + this.way(left, right) - this.way(left, head) - this.way(tail, right);
      if (gain < LEAST_GAIN) continue;
      this.moveAfter(a, b, after, isTurned);
      return gain;
    }
    return 0;
  }

  private turn(first: number, last: number): void {
    const { begun } = this;
    let i = first;
    for (let j = last; i <= j; i++, j--) {
      const one = begun[i];
      begun[i] = begun[j] ^ 1;
      begun[j] = one ^ 1;
    }
    this.note(first, last);
  }

  private moveAfter(a: number, b: number, after: number, isTurned: boolean): void {
    if (isTurned) this.turn(a, b);
    const { begun } = this;
    const stretch = begun.slice(a, b + 1);
    if (after < a) {
      begun.copyWithin(after + 1 + stretch.length, after + 1, a);
      begun.set(stretch, after + 1);
    } else {
      begun.copyWithin(a, b + 1, after + 1);
      begun.set(stretch, after + 1 - stretch.length);
    }
    this.note(Math.min(a, after + 1), Math.max(b, after));
  }

  /** Notes where the paths of a stretch are in the order. */
  private note(first: number, last: number): void {
    for (let i = first; i <= last; i++) this.places[this.begun[i] >> 1] = i;
  }
}
