/** The twin of shaders/chunks/safeNormalize.glsl. */
import { tsl, type Value } from '../base/values.js';

const { dot, inverseSqrt, vec3 } = tsl;

/** A zero-area triangle has no normal; one towards the viewer is as good as any for the pixel it may still cover. */
export function safeNormalize(v: Value): Value {
  // So little turns no other vector, and its square is still a number.
  const any = v.add(vec3(0, 0, 2e-19)).toVar();
  return any.mul(inverseSqrt(dot(any, any))).toVar();
}
