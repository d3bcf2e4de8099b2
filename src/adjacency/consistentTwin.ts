import { NO_TWIN } from '../mesh/corners.js';
import type { TriangleAdjacency } from './buildTriangleAdjacency.js';

/** The twin of the edge that starts at `corner`; NO_TWIN also where the two windings contradict each other. */
export function consistentTwin(
  { twins, canonicalCorners }: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners'>,
  corner: number,
): number {
  const twin = twins[corner];
  return twin === NO_TWIN || canonicalCorners[corner] === canonicalCorners[twin] ? NO_TWIN : twin;
}
