import type { Value } from '../base/values.js';

/** The directions of strokes in the surface. */
export interface StrokeAxes {
  /** The strokes' u and v in the surface, object space. */
  uAxis: Value;
  vAxis: Value;
  /** How far the lights disagree. */
  crossing: Value;
}
