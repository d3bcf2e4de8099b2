import type { EdgeCounts } from '../adjacency/EdgeCounts.js';

/** The content of `userData.hatching` of a prepared geometry. */
export interface HatchingStatistics extends EdgeCounts {
  /** Triangles drawn, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'pull' | 'indexed';
  /** Bytes of all vertex, index, morph and texture data of the prepared geometry. */
  bytes: number;
}
