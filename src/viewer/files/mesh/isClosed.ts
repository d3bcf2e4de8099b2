import type { PlainMesh } from './PlainMesh.js';

/**
 * Whether the triangles of a mesh enclose something, all with the same winding: each edge is run along as often in one direction as in
 * the other. Vertices at one place are not joined, so a mesh with seams counts as open.
 *
 * Every edge adds a number for its direction, and the opposite number for the other one: only if all go in pairs is the sum 0. That an
 * open mesh gives 0 too has a chance of one in four billion.
 */
export function isClosed({ indices }: Pick<PlainMesh, 'indices'>): boolean {
  if (!indices) return false;
  let sum = 0;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = scatter(indices[i]);
    const b = scatter(indices[i + 1]);
    const c = scatter(indices[i + 2]);
    // Antisymmetric in the ends of the edge, and not a difference of two numbers, which would cancel around any triangle.
    sum = (sum + scatter(a ^ Math.imul(b, 3)) - scatter(b ^ Math.imul(a, 3))) | 0;
    sum = (sum + scatter(b ^ Math.imul(c, 3)) - scatter(c ^ Math.imul(b, 3))) | 0;
    sum = (sum + scatter(c ^ Math.imul(a, 3)) - scatter(a ^ Math.imul(c, 3))) | 0;
  }
  return sum === 0;
}

/** The finaliser of MurmurHash3 (Austin Appleby, public domain). */
function scatter(word: number): number {
  let h = Math.imul(word ^ (word >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
