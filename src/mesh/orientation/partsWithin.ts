import type { Part } from './measureParts.js';

/** Returns a function for the other parts whose bounding boxes lie within that of a part. They are sorted along x, so that few are compared. */
export function partsWithin(parts: readonly Part[]): (outer: number) => number[] {
  const order = [...parts.keys()].sort((a, b) => parts[a].least[0] - parts[b].least[0]);
  return (outer) => {
    const box = parts[outer];
    const found: number[] = [];
    for (let at = firstFrom(order, parts, box.least[0]); at < order.length; at++) {
      const part = parts[order[at]];
      if (part.least[0] > box.most[0]) break;
      if (part !== box && isWithin(part, box)) found.push(order[at]);
    }
    return found;
  };
}

/** Whether the bounding box of a part lies within that of another. */
export function isWithin(inner: Part, outer: Part): boolean {
  for (let k = 0; k < 3; k++) if (inner.least[k] < outer.least[k] || inner.most[k] > outer.most[k]) return false;
  return true;
}

/** The first place in a sorted order whose part begins at x or behind it. */
function firstFrom(order: readonly number[], parts: readonly Part[], x: number): number {
  let [low, high] = [0, order.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (parts[order[middle]].least[0] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}
