import type { Light } from 'three';
import type { Value } from './values.js';

/** What is known at a fragment of a light that casts shadows. */
export interface ToldLight {
  light: Light;
  /** 1 where all of it arrives, 0 where nothing does. */
  shadow: Value;
  /** What is left of the tone of its shadow; null where shadows do not dissolve. */
  toneLeft: Value | null;
  /** Whether strokes no longer run by it; null where they always do. */
  isShadowed: Value | null;
}
