import { NO_TWIN, nextCorner, previousCorner } from '../corners.js';
import { asPhase, forEachChunk, release } from '../phases.js';

/**
 * A fan is a set of corners around a vertex that are connected across edges with twins. The surface is smooth within a fan: a
 * vertex on a crease has one fan, and so one normal, on each side of the crease.
 */
export interface Fans {
  /** For each corner the number of its fan. Fans are numbered in the order of their first corners. */
  ofCorner: Uint32Array<ArrayBuffer>;
  count: number;
}

/** Stands for the number of a fan where there is no fan. */
export const NO_FAN = 0xffffffff;

/**
 * Finds the fans by walking around the vertices. Fans continue across welded seams. They end at borders, at creases that were
 * cut before, and at edges where the windings contradict each other. It takes linear time, even if 100,000 triangles meet in
 * one vertex.
 *
 * @param twins without those of edges where the windings contradict each other (`consistentTwins`)
 */
export function* buildFans(twins: Int32Array): Generator<number, Fans, void> {
  const ofCorner = new Uint32Array(twins.length).fill(NO_FAN);
  let count = 0;
  yield* forEachChunk(twins.length, (start, end) => {
    count = walkRange(twins, ofCorner, count, start, end);
  });
  return { ofCorner, count };
}

/** Numbers the fans that begin in a range of corners. `count` fans have a number already. */
function walkRange(twins: Int32Array, ofCorner: Uint32Array, count: number, start: number, end: number): number {
  let fan = count;
  for (let first = start; first < end; first++) {
    if (ofCorner[first] !== NO_FAN) continue;
    // Walk across the edges that start at the vertex, until the walk is back where it started or reaches a border …
    let corner = first;
    do {
      ofCorner[corner] = fan;
      const twin = twins[corner];
      corner = twin === NO_TWIN ? first : nextCorner(twin);
    } while (corner !== first);
    // … and then the other way, across the edges that end at the vertex. After a closed walk nothing is left to number.
    for (let twin = twins[previousCorner(first)]; twin !== NO_TWIN && ofCorner[twin] === NO_FAN; ) {
      ofCorner[twin] = fan;
      twin = twins[previousCorner(twin)];
    }
    fan++;
  }
  return fan;
}

/** Fans, and the twins they were built from. */
interface CutSurface {
  twins: Int32Array;
  fans: Fans;
}

/** Fans in another order. */
export interface SortedFans {
  /** For each of the sorted fans its number before sorting. */
  order: Uint32Array<ArrayBuffer>;
  /** For each fan, by its number before sorting, its number now. */
  numbers: Uint32Array<ArrayBuffer>;
  /** The number of edges of each of the sorted fans, followed by a 0. */
  sizes: Uint32Array<ArrayBuffer>;
}

/** Sorts fans by their number of edges, as far as that keeps neighbours near each other; see `orderBySize`. */
export function* sortFans(surface: CutSurface): Generator<number, SortedFans, void> {
  const { count } = surface.fans;
  const unsorted = yield* asPhase(countEdges(surface), 0, 0.7);
  const order = yield* asPhase(orderBySize(unsorted, count), 0.7, 1);
  const numbers = new Uint32Array(count);
  const sizes = new Uint32Array(count + 1);
  for (let i = 0; i < count; i++) {
    numbers[order[i]] = i;
    sizes[i] = unsorted[order[i]];
  }
  release(unsorted);
  return { order, numbers, sizes };
}

/** The fans in their given order. */
export function* fansInOrder(surface: CutSurface): Generator<number, SortedFans, void> {
  const order = new Uint32Array(surface.fans.count);
  for (let fan = 0; fan < order.length; fan++) order[fan] = fan;
  return { order, numbers: order, sizes: yield* countEdges(surface) };
}

/** Counts the edges of each fan. The array has one entry more, which is 0. */
function* countEdges(surface: CutSurface): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const sizes = new Uint32Array(surface.fans.count + 1);
  yield* forEachChunk(surface.twins.length, (start, end) => countRange(surface, sizes, start, end));
  return sizes;
}

/** Counts the edges of each fan. A half-edge counts for the fan it starts from; without a twin it also counts for its end. */
function countRange({ twins, fans: { ofCorner } }: CutSurface, sizes: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    sizes[ofCorner[corner]]++;
    if (twins[corner] === NO_TWIN) sizes[ofCorner[nextCorner(corner)]]++;
  }
}

/** Number of nodes per sorted block, so that nodes near each other stay near each other in memory. */
const BLOCK = 1 << 14;

/** Nodes with more edges, which are few, count as having this many. */
const MOST_EDGES = 31;

/**
 * Sorts the nodes of each block by their number of edges, then by their numbers (counting sort), in linear time. Yields its progress.
 *
 * @param sizes the number of edges of each node; entries beyond `count` are ignored
 * @returns the numbers of the nodes in their new order
 */
export function* orderBySize(sizes: Uint32Array, count: number): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const order = new Uint32Array(count);
  for (let first = 0; first < count; first += BLOCK) {
    sortBlock(sizes, order, first, Math.min(first + BLOCK, count));
    yield first / count;
  }
  return order;
}

function sortBlock(sizes: Uint32Array, order: Uint32Array, first: number, end: number): void {
  const slots = new Uint32Array(MOST_EDGES + 2);
  for (let node = first; node < end; node++) slots[Math.min(sizes[node], MOST_EDGES) + 1]++;
  for (let size = 1; size < slots.length; size++) slots[size] += slots[size - 1];
  for (let node = first; node < end; node++) order[first + slots[Math.min(sizes[node], MOST_EDGES)]++] = node;
}
