/** Counterpart of shaders/techniques/anchored/varyings.glsl. */
import { tsl, type Value } from '../base/values.js';

const { varyingProperty } = tsl;

/** Object space. */
export const vRestPosition: Value = /* @__PURE__ */ varyingProperty('vec3', 'vRestPosition');
/** At the scale of a stroke, object space. */
export const vStrokeNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vStrokeNormal');
/** Object units to a pixel. */
export const vUnitsPerPixel: Value = /* @__PURE__ */ varyingProperty('float', 'vUnitsPerPixel');
/** Object space, of any length. */
export const vToViewer: Value = /* @__PURE__ */ varyingProperty('vec3', 'vToViewer');
/** Gradient of the function along whose level lines strokes run, object space, of any length. */
export const vFormSlope: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFormSlope');
