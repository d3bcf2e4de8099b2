/** The twin of shaders/techniques/engraved/varyings.glsl. Field space: that of the object, or one for all objects of a scene, in tiles. */
import { tsl, type Value } from '../../values.js';

const { varyingProperty } = tsl;

export const vFieldPoint: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldPoint');
/** At the scale of a stroke. */
export const vFieldNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldNormal');
/** The same all over the object: the axis, unit, and the bend of the function that lines are level sets of. */
export const vField: Value = /* @__PURE__ */ varyingProperty('vec4', 'vField');
