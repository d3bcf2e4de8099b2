/** The twin of shaders/chunks/largestComponents.glsl. */
import { tsl, type Value } from '../base/values.js';

const { max, min, step } = tsl;

/** Marks the largest component of a vector with 1, and the two largest. Ties go the same way in all components. */
export function largestComponents(v: Value): { largest: Value; twoLargest: Value } {
  const greater = step(v.yzx, v.xyz).toVar();
  const less = greater.oneMinus().toVar();
  return { largest: min(greater, less.zxy).toVar(), twoLargest: max(greater, less.zxy).toVar() };
}
