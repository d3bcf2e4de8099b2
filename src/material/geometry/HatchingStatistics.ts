import type { EdgeCounts } from '../../mesh/adjacency/pairEdges.js';
import type { Repairs } from './repairValues.js';

/** The value of `userData.hatching` on a prepared geometry. */
export interface HatchingStatistics extends EdgeCounts, Repairs {
  /** The number of triangles, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'pull' | 'indexed';
  /** The field of engraved lines with `lineField: 'auto'`: the form if the geometry was prepared for it, otherwise the light. */
  lineField: 'form' | 'light';
  /** The size of all vertex, index, morph and texture data of the prepared geometry, in bytes. */
  bytes: number;
}
