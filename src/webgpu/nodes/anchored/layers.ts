/** Counterpart of shaders/techniques/anchored/layers.glsl. */
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type Input, tsl, type Value } from '../base/values.js';
import { tilesPerUnit } from '../chunks/levelByDepth.js';
import type { HatchingParameters } from './read.js';

const { vec3 } = tsl;

/** Tiles between anchors. */
export const anchorSpacing: Value = /* @__PURE__ */ hatchingUniform('anchorSpacing', 'float');

export const crossingOf = ({ crossing }: HatchingParameters): Value => crossing;

/** The same place in another layer, whose strokes are turned. @param turn cosine and sine of the angle */
export function turnedLayer(h: HatchingParameters, layer: number, [x, y]: readonly [Input, Input]): HatchingParameters {
  const { uAxis, vAxis, lean } = h;
  const shift = vec3(...TONE_CONSTANTS.LAYER_SHIFT).mul(anchorSpacing.div(tilesPerUnit).mul(layer));
  return {
    ...h,
    point: h.point.add(shift).toVar(),
    uAxis: uAxis.mul(x).sub(vAxis.mul(y)).toVar(),
    vAxis: uAxis.mul(y).add(vAxis.mul(x)).toVar(),
    lean: vec3(lean.x.mul(x).sub(lean.y.mul(y)), lean.x.mul(y).add(lean.y.mul(x)), lean.z).toVar(),
  };
}
