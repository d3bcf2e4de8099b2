/** The twin of shaders/chunks/localColor.glsl: what the surface's own colour gives to the picture. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { lightLuminance } from './lightLuminance.js';
import { lightness } from './lightness.js';

const { clamp, float, min, mix, vec3 } = tsl;

const localTone = /* @__PURE__ */ hatchingUniform('localTone', 'float');
const colorExposure = /* @__PURE__ */ hatchingUniform('colorExposure', 'float');
const colorFill = /* @__PURE__ */ hatchingUniform('colorFill', 'float');

/** How much darker than white a colour looks, as far as that is to become tone. What gives off light itself does not look so dark. */
export function localDarkness(color: Value, emitted: Value): Value {
  const light = min(colorExposure.mul(lightness(clamp(lightLuminance(color), 0, 1))), 1);
  const unlit = float(1).sub(clamp(lightLuminance(emitted), 0, 1));
  return localTone.mul(float(1).sub(light)).mul(unlit);
}

export const filledColor = (color: Value): Value => mix(vec3(1), color, colorFill);
