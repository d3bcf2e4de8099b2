import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { countEdges, type FanSurface } from './assembleHeatEquation.js';
import type { Fans } from './buildFans.js';

/** Fans in another order. */
export interface SortedFans {
  fans: Fans;
  /** For each of the sorted fans its number before. */
  order: Uint32Array<ArrayBuffer>;
  /** The number of edges of each of the sorted fans, and a 0. */
  sizes: Uint32Array<ArrayBuffer>;
}

/** Fans are sorted in blocks of as many, so that fans which lie near each other stay near each other in memory. */
const BLOCK = 1 << 14;

/** A fan with more edges counts as having as many: such fans are few. */
const MOST_EDGES = 31;

/** Sorts the fans of each block by their number of edges, and else by their numbers (counting sort). It takes linear time. */
export function* sortFans(surface: Pick<FanSurface, 'twins' | 'fans'>): Generator<number, SortedFans, void> {
  const { ofCorner, count } = surface.fans;
  const unsorted = yield* asPhase(countEdges(surface), 0, 0.5);
  const order = new Uint32Array(count);
  const numbers = new Uint32Array(count);
  const sizes = new Uint32Array(count + 1);
  for (let first = 0; first < count; first += BLOCK) {
    sortBlock(unsorted, order, first, Math.min(first + BLOCK, count));
    yield 0.5 + 0.2 * (first / count);
  }
  for (let i = 0; i < count; i++) {
    numbers[order[i]] = i;
    sizes[i] = unsorted[order[i]];
  }
  const sorted = new Uint32Array(ofCorner.length);
  yield* asPhase(
    forEachChunk(ofCorner.length, (start, end) => renumberRange(ofCorner, numbers, sorted, start, end)),
    0.7,
    1,
  );
  return { fans: { ofCorner: sorted, count }, order, sizes };
}

function sortBlock(sizes: Uint32Array, order: Uint32Array, first: number, end: number): void {
  const slots = new Uint32Array(MOST_EDGES + 2);
  for (let fan = first; fan < end; fan++) slots[Math.min(sizes[fan], MOST_EDGES) + 1]++;
  for (let size = 1; size < slots.length; size++) slots[size] += slots[size - 1];
  for (let fan = first; fan < end; fan++) order[first + slots[Math.min(sizes[fan], MOST_EDGES)]++] = fan;
}

function renumberRange(
  ofCorner: Uint32Array,
  numbers: Uint32Array,
  sorted: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) sorted[corner] = numbers[ofCorner[corner]];
}
