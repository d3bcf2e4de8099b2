/**
 * Counterpart of shaders/outlines/dryOutline.glsl: outlines of pencil, charcoal and chalk. They are soft at their sides, vary in pressure
 * along the way, and catch on the tooth of the paper.
 */

import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { normalDistribution } from '../chunks/normalDistribution.js';
import { toothField } from '../chunks/tooth.js';

const { clamp, float, min } = tsl;

const tooth = /* @__PURE__ */ hatchingUniform('tooth', 'float');

/** The tooth above which the sides fade from the middle on. */
const SOFT_TOOTH = 0.3;
/** The effect of tooth on outlines, which are pressed harder than hatching. */
const CAUGHT = 0.75;
/** The range of pressures over which an outline goes from none to full ink. */
const OUTLINE_SOFTNESS = 0.65;
/** The share of pressure that an unsteady hand loses along the way. */
const LIFTED = 0.5;

/**
 * The share of full ink that is left.
 *
 * @param across 0 in the middle of the outline, 1 at its side
 * @param along a wave along it, from −1 to 1
 * @param pixel of the render target, counted from the lower left
 */
export function dryInk(across: Value, along: Value, pixel: Value): Value {
  const side = min(tooth.div(SOFT_TOOTH), 1).mul(across).mul(across);
  const loss = tooth.mul(LIFTED).mul(float(0.5).sub(along.mul(0.5)));
  const pressure = side.oneMinus().mul(loss.oneMinus());
  const height = normalDistribution(toothField(pixel)).x;
  return clamp(pressure.sub(tooth.mul(CAUGHT).mul(height)).div(OUTLINE_SOFTNESS), 0, 1);
}
