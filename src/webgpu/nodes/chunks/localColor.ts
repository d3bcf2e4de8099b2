/** Counterpart of shaders/chunks/localColor.glsl: the tone and the tint of the surface's own colour. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { lightLuminance } from './lightLuminance.js';
import { lightness } from './lightness.js';

const { clamp, float, min, mix, vec3 } = tsl;

const localTone = /* @__PURE__ */ hatchingUniform('localTone', 'float');
const colorExposure = /* @__PURE__ */ hatchingUniform('colorExposure', 'float');
const colorFill = /* @__PURE__ */ hatchingUniform('colorFill', 'float');

/** The darkness of a colour beside white, as far as it becomes tone. Emitted light lessens it. */
export function localDarkness(color: Value, emitted: Value): Value {
  const light = min(colorExposure.mul(lightness(clamp(lightLuminance(color), 0, 1))), 1);
  const unlit = float(1).sub(clamp(lightLuminance(emitted), 0, 1));
  return localTone.mul(float(1).sub(light)).mul(unlit);
}

export const filledColor = (color: Value): Value => mix(vec3(1), color, colorFill);
