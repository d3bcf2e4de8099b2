import type { EdgeCounts } from '../adjacency/EdgeCounts.js';

/** What a prepared geometry carries as `userData.hatching`. */
export interface HatchingStatistics extends EdgeCounts {
  /** Triangles drawn, degenerate ones included. */
  triangles: number;
  /** The vertex layout. */
  layout: 'corner' | 'indexed';
  /** Bytes of all vertex, index and morph data of the prepared geometry. */
  bytes: number;
}
