import { NO_TWIN } from '../mesh/corners.js';

/**
 * The twin of the edge that starts at `corner`; NO_TWIN also where the two windings contradict each other.
 *
 * Takes the arrays and not what holds them: its callers' objects differ in shape, which engines do not inline.
 */
export function consistentTwin(twins: Int32Array, canonicalCorners: Uint32Array, corner: number): number {
  const twin = twins[corner];
  return twin === NO_TWIN || canonicalCorners[corner] === canonicalCorners[twin] ? NO_TWIN : twin;
}
