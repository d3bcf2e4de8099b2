/** Counterpart of shaders/techniques/engraved/varyings.glsl. Field space: that of the object, or one for all objects of a scene, in tiles. */
import { tsl, type Value } from '../base/values.js';

const { varyingProperty } = tsl;

export const vFieldPoint: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldPoint');
/** The normal smoothed to the scale of a stroke. */
export const vFieldNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldNormal');
/** The axis of the field, unit, and the curvature of its function; constant over an object. */
export const vField: Value = /* @__PURE__ */ varyingProperty('vec4', 'vField');
/** Unit direction towards the light, and reciprocal of its distance, 0 for directional lights; for fields that are read per fragment. */
export const vFieldLight: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFieldLight');
/** Gradient of a function, per tile, and its value minus half of the gradient's product with the position. */
export const vForm: Value = /* @__PURE__ */ varyingProperty('vec4', 'vForm');
/** The same for the crossing lines. */
export const vFormCrossing: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFormCrossing');
