/** Nodes are sorted in blocks of as many, so that those which lie near each other stay near each other in memory. */
const BLOCK = 1 << 14;

/** A node with more edges counts as having as many: such nodes are few. */
const MOST_EDGES = 31;

/**
 * Sorts the nodes of each block by their number of edges, and else by their numbers (counting sort). It takes linear time, and yields its
 * progress.
 *
 * @param sizes the number of edges of each node; entries beyond `count` do not matter
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
