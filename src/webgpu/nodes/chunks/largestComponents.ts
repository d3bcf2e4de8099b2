/** Counterpart of shaders/chunks/largestComponents.glsl. */
import { tsl, type Value } from '../base/values.js';

const { max, min, step } = tsl;

/** Masks of the largest component of a vector and of the two largest, with ties broken consistently. */
export function largestComponents(v: Value): { largest: Value; twoLargest: Value } {
  const greater = step(v.yzx, v.xyz).toVar();
  const less = greater.oneMinus().toVar();
  return { largest: min(greater, less.zxy).toVar(), twoLargest: max(greater, less.zxy).toVar() };
}
