import type { CornerRange } from './cornerRange.js';

/**
 * For each triangle the material index of its group plus 1, or 0 outside of all groups. Returns null if there are no groups, or if
 * one group holds all triangles.
 */
export function triangleGroups({ count, groups }: CornerRange): Uint16Array<ArrayBuffer> | null {
  if (groups.length === 0 || (groups.length === 1 && groups[0].count === count)) return null;
  const ofTriangle = new Uint16Array(count / 3);
  for (const { start, count: length, materialIndex = 0 } of groups) {
    ofTriangle.fill(1 + materialIndex, start / 3, (start + length) / 3);
  }
  return ofTriangle;
}
