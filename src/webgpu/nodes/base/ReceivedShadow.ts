import type { Light } from 'three';
import type { Value } from './values.js';

/** A light that casts shadows, at a fragment. */
export interface ReceivedShadow {
  light: Light;
  /** 1 where all of it arrives, 0 where nothing does. */
  shadow: Value;
  /** The share of the tone of its shadow that is left; null where shadows do not dissolve. */
  toneLeft: Value | null;
  /** Whether it is so shadowed that strokes no longer follow it; null where they always do. */
  isShadowed: Value | null;
}
