/** Counterpart of shaders/techniques/engraved/formAttributes.glsl: the baked functions of lines that follow the form. */
import { formLayout } from '../../../mesh/bake/attributeLayouts.js';
import { tsl, type Value } from '../base/values.js';

const { attribute, dot, exp2, round, vec4 } = tsl;

export const formValue = (): Value => attribute(formLayout.value.name, 'vec2');
export const formSlope = (): Value => attribute(formLayout.slope.name, 'vec4');
export const formCrossing = (): Value => attribute(formLayout.crossing.name, 'vec4');

/**
 * @param slope a gradient in object space, as packed
 * @param place field space
 */
export function formVarying(slope: Value, value: Value, toField: Value, place: Value): Value {
  const gradient = toField
    .mul(slope.xyz)
    .mul(exp2(round(slope.w.mul(32767))))
    .toVar();
  return vec4(gradient, value.sub(dot(gradient, place).mul(0.5)));
}
