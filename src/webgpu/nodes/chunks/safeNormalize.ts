/** Counterpart of shaders/chunks/safeNormalize.glsl. */
import { tsl, type Value } from '../base/values.js';

const { dot, inverseSqrt, vec3 } = tsl;

/** The unit vector, or the direction to the viewer for the null vector that a zero-area triangle has for a normal. */
export function safeNormalize(v: Value): Value {
  // Too small to turn any other vector, and large enough for its square not to underflow.
  const any = v.add(vec3(0, 0, 2e-19)).toVar();
  return any.mul(inverseSqrt(dot(any, any))).toVar();
}
