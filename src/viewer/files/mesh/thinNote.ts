import { isAreaLess } from './triangleAreas.js';

/** A model with a radius of 1 and less surface than this is less than a pixel wide wherever it is seen. */
const LEAST_AREA = 0.002;

/**
 * Says of a model with a radius of 1 that its triangles are slivers or dust, which strokes cannot show.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param share of all triangles that these are
 */
export function thinNote(positions: ArrayLike<number>, indices: ArrayLike<number> | null, share = 1): string[] {
  return isAreaLess(positions, indices, LEAST_AREA * share) ? ['its triangles are too thin to be hatched'] : [];
}
