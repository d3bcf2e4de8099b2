/** Counterpart of shaders/chunks/normalDistribution.glsl. */
import { tsl, type Value } from '../base/values.js';

const { exp, float, vec2 } = tsl;

/** Φ, the standard normal distribution, to 2e-4, and its slope. */
export function normalDistribution(g: Value): Value {
  const at = g.toVar();
  const cube = at.mul(at).mul(at);
  const h = float(1)
    .div(exp(at.add(cube.mul(0.044715)).mul(-1.5957691216)).add(1))
    .toVar();
  const slope = h.mul(h.oneMinus()).mul(1.5957691216).mul(at.mul(at).mul(0.134145).add(1));
  return vec2(h, slope);
}
