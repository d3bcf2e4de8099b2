/** The twin of shaders/techniques/engraved/varyings.glsl. Field space: that of the object, or one for all objects of a scene, in tiles. */
import { tsl, type Value } from '../base/values.js';

const { varyingProperty } = tsl;

export const vFieldPoint: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldPoint');
/** At the scale of a stroke. */
export const vFieldNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldNormal');
/** The same all over the object: the axis, unit, and the bend of the function that lines are level sets of. */
export const vField: Value = /* @__PURE__ */ varyingProperty('vec4', 'vField');
/** Towards the light, unit, and one over its distance, 0 without an end: where the field is known at a fragment alone. */
export const vFieldLight: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFieldLight');
/** The gradient of a function, per tile, and its value less half of what the gradient makes of the place. */
export const vForm: Value = /* @__PURE__ */ varyingProperty('vec4', 'vForm');
/** The same of the lines that cross. */
export const vFormCrossing: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFormCrossing');
