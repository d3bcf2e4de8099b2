import type { Value } from '../../values.js';
import type { Family } from './ruledLines.js';

/** What engraving needs to know at a fragment: the functions that lines are level sets of, and how they lie on the screen. */
export interface HatchingParameters {
  /** Of the hand. */
  pressure: Value;
  /** How far the first family has lines. */
  has: Value;
  /** The share of what crosses that the family B takes. */
  shareB: Value;
  firstFamily(): Family;
  /**
   * @param isB towards which side it leans
   * @param lean cosine and sine of the angle at which it crosses the first
   */
  crossingFamily(isB: boolean, lean: readonly [cosine: Value, sine: Value]): Family;
}
