import { isAreaLess } from './triangleAreas.js';

/** A model of radius 1 with less surface area than this is thinner than a pixel everywhere. */
const LEAST_AREA = 0.002;

/**
 * A note for a model of radius 1 whose triangles are slivers or dust that strokes cannot show.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param share of all triangles that these are
 */
export function thinNote(positions: ArrayLike<number>, indices: ArrayLike<number> | null, share = 1): string[] {
  return isAreaLess(positions, indices, LEAST_AREA * share) ? ['its triangles are too thin to be hatched'] : [];
}
