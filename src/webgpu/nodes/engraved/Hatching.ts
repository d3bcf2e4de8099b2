import type { Light } from 'three';
import type { ToldLight } from '../base/ToldLight.js';
import type { Input, Value } from '../base/values.js';
import type { ScreenMap } from '../perFragment/screenGradient.js';

/** Lines that are level sets of one function. */
export interface Family {
  value: Value;
  /** Its change from one pixel to the next, by the smooth normal. */
  perPixel: Value;
  /** The same on the flat triangle, as it is seen. */
  seen: Value;
  /** Its change along the surface, per tile, by which lines are spaced on the object. */
  rise: Value;
  /** Of any length; lines lie across it. */
  gradient: Value;
  /** The octave of the lines that lie farthest apart. */
  coarsest: Input;
  /** Whether the number of a line changes across the seams of a bake. */
  isOfForm: boolean;
}

/** What the shadows of a place say of its lines. */
export interface LinesInShadow {
  lights: readonly Light[];
  told: readonly ToldLight[];
  /** Where shadows alone are drawn: how much of their tone is left. Null elsewhere. */
  shadowLeft: Value | null;
}

/** What engraving needs to know at a fragment: the functions that lines are level sets of, and how they lie on the screen. */
export interface HatchingParameters {
  onScreen: ScreenMap;
  /** Where shadows alone are drawn: how much of their tone is left. Null elsewhere. */
  shadowLeft: Value | null;
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
   * @param isOther whether that angle is the negative one
   */
  crossingFamily(isB: boolean, lean: readonly [cosine: Value, sine: Value], isOther: boolean): Family;
}
