import type { ToldLight } from './ToldLight.js';
import type { Value } from './values.js';

/** What light makes of a surface at a fragment. */
export interface HatchingSurface {
  radiance: Value;
  /** What shadows have taken of it; null where they are not told from the light. */
  shadowed: Value | null;
  /** How much of the tone of all shadows is left; null where they do not dissolve. */
  shadowLeft: Value | null;
  /** Of its own colour, as far as that becomes tone. */
  darkness: Value;
  /** The lights that cast shadows, where these are told from the light. */
  told: readonly ToldLight[];
}
