import { hatchingUniform } from './uniforms.js';
import type { Value } from './values.js';

/** Cosine and sine of the strokes' rotation. */
export const strokeDirection: Value = /* @__PURE__ */ hatchingUniform('strokeDirection', 'vec2');
