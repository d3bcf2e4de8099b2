import { hatchingUniform } from '../base/uniforms.js';
import type { Value } from '../base/values.js';

/** 0: lines spaced on the object, 1: on the screen. */
export const sizedOnScreen: Value = /* @__PURE__ */ hatchingUniform('sizedOnScreen', 'float');
