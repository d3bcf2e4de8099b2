import type { Light } from 'three';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import type { Input, Value } from '../base/values.js';
import type { ScreenMap } from '../perFragment/screenGradient.js';

/** Lines that are level sets of one function. */
export interface Family {
  value: Value;
  /** Its change from one pixel to the next, on the smooth surface. */
  perPixel: Value;
  /** Its change from one pixel to the next on the flat triangle. */
  seen: Value;
  /** Its change along the surface, per tile, by which lines are spaced on the object. */
  rise: Value;
  /** Its gradient, of any length; lines lie across it. */
  gradient: Value;
  /** The octave of the widest spacing of its lines. */
  coarsest: Input;
  /** Whether line numbers change across the seams of a bake. */
  isOfForm: boolean;
}

/** The shadows at a fragment, as far as lines depend on them. */
export interface LinesInShadow {
  lights: readonly Light[];
  receivedShadows: readonly ReceivedShadow[];
  /** The share of the shadows' tone that is left where shadows alone are drawn; null elsewhere. */
  shadowLeft: Value | null;
}

/** The parameters of engraving at a fragment: the functions whose level sets are lines, and their derivatives on the screen. */
export interface HatchingParameters {
  onScreen: ScreenMap;
  /** The share of the shadows' tone that is left where shadows alone are drawn; null elsewhere. */
  shadowLeft: Value | null;
  /** Pressure of the hand. */
  pressure: Value;
  /** The share to which the first family has lines here. */
  has: Value;
  /** The share of the crossing tone that family B takes. */
  shareB: Value;
  firstFamily(): Family;
  /**
   * A family that crosses the first.
   *
   * @param isB the side towards which it leans
   * @param lean cosine and sine of the angle at which it crosses the first
   * @param isOther whether the sine is negative
   */
  crossingFamily(isB: boolean, lean: readonly [cosine: Value, sine: Value], isOther: boolean): Family;
}
