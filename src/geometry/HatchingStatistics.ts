import type { EdgeCounts } from '../adjacency/EdgeCounts.js';
import type { Repairs } from './repairValues.js';

/** The content of `userData.hatching` of a prepared geometry. */
export interface HatchingStatistics extends EdgeCounts, Repairs {
  /** Triangles drawn, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'pull' | 'indexed';
  /** Bytes of all vertex, index, morph and texture data of the prepared geometry. */
  bytes: number;
}
