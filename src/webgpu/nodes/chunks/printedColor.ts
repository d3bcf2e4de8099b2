/** Counterpart of shaders/chunks/printedColor.glsl: ink and paper as one colour with an alpha, not premultiplied. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { float, max, mix, vec4 } = tsl;

const ink = /* @__PURE__ */ hatchingUniform('ink', 'color');
export const paper: Value = /* @__PURE__ */ hatchingUniform('paper', 'color');
const paperOpacity = /* @__PURE__ */ hatchingUniform('paperOpacity', 'float');

/**
 * @param ground paper, tinted by the surface colour
 * @param darkness of the hatch
 * @param isMultiplied whether strokes are tinted by the ground too
 */
export function printedColor(ground: Value, darkness: Value, isMultiplied: boolean, isOpaque: boolean): Value {
  const stroke = isMultiplied ? ground.mul(ink) : ink;
  if (isOpaque) return vec4(mix(ground, stroke, darkness), 1);
  const alpha = float(1)
    .sub(float(1).sub(paperOpacity).mul(float(1).sub(darkness)))
    .toVar();
  return vec4(mix(ground.mul(paperOpacity), stroke, darkness).div(max(alpha, 1e-6)), alpha);
}
