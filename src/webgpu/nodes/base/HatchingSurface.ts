import type { ReceivedShadow } from './ReceivedShadow.js';
import type { Value } from './values.js';

/** The lighting of a surface at a fragment. */
export interface HatchingSurface {
  radiance: Value;
  /** Radiance that shadows have taken; null where shadows are not computed apart. */
  shadowed: Value | null;
  /** The share of the shadows' tone that is left; null where they do not dissolve. */
  shadowLeft: Value | null;
  /** The darkness of the surface's own colour, as far as it becomes tone. */
  darkness: Value;
  /** The lights that cast shadows, where shadows are computed apart. */
  receivedShadows: readonly ReceivedShadow[];
}
