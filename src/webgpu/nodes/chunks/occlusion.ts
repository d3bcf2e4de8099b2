/** Counterpart of shaders/chunks/occlusion.glsl: 0 where a surface sees the whole sky, 1 where it sees none of it. */
import { tsl, type Value } from '../base/values.js';

/** The baked ambient occlusion. */
export const vOcclusion: Value = /* @__PURE__ */ tsl.varyingProperty('float', 'vOcclusion');
