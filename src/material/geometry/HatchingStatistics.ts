import type { EdgeCounts } from '../../mesh/adjacency/pairEdges.js';
import type { Repairs } from './repairValues.js';

/** The content of `userData.hatching` of a prepared geometry. */
export interface HatchingStatistics extends EdgeCounts, Repairs {
  /** The number of triangles, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'pull' | 'indexed';
  /** What engraved lines with `lineField: 'auto'` follow: the form if the geometry was prepared for it, the light if not. */
  lineField: 'form' | 'light';
  /** The size of all vertex, index, morph and texture data of the prepared geometry, in bytes. */
  bytes: number;
}
