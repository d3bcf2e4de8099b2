/**
 * Union-find over 0 … count − 1. `parents[i]` is another member of the set of i, or i itself if i is the root, which is the
 * smallest member. It takes near-linear time, even for a single set of 100,000.
 */
export function disjointSets(count: number): Uint32Array<ArrayBuffer> {
  const parents = new Uint32Array(count);
  for (let i = 0; i < count; i++) parents[i] = i;
  return parents;
}

/** The root of a member's set. The search halves the path to it. */
export function rootOf(parents: Uint32Array, member: number): number {
  let root = member;
  for (let parent = parents[root]; parent !== root; parent = parents[root]) {
    const grandparent = parents[parent];
    parents[root] = grandparent;
    root = grandparent;
  }
  return root;
}

/** Merges the sets of `a` and `b`. */
export function join(parents: Uint32Array, a: number, b: number): void {
  const rootA = rootOf(parents, a);
  const rootB = rootOf(parents, b);
  parents[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
}
