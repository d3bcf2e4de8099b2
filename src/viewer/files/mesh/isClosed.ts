import type { PlainMesh } from './PlainMesh.js';

/**
 * Whether the triangles of a mesh form a closed surface with consistent winding: each edge occurs as often in one direction as in the
 * other. Vertices are compared by index, so a mesh with seams counts as open. Each directed edge adds a hash that its reverse cancels; an
 * open mesh sums to 0 by chance once in four billion.
 */
export function isClosed({ indices }: Pick<PlainMesh, 'indices'>): boolean {
  if (!indices) return false;
  let sum = 0;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = scatter(indices[i]);
    const b = scatter(indices[i + 1]);
    const c = scatter(indices[i + 2]);
    // Antisymmetric in the ends of the edge. A mere difference of two hashes would cancel around any triangle.
    sum = (sum + scatter(a ^ Math.imul(b, 3)) - scatter(b ^ Math.imul(a, 3))) | 0;
    sum = (sum + scatter(b ^ Math.imul(c, 3)) - scatter(c ^ Math.imul(b, 3))) | 0;
    sum = (sum + scatter(c ^ Math.imul(a, 3)) - scatter(a ^ Math.imul(c, 3))) | 0;
  }
  return sum === 0;
}

/** The finalizer of MurmurHash3 (Austin Appleby, public domain). */
function scatter(word: number): number {
  let h = Math.imul(word ^ (word >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
