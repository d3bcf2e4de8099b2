/** Counterpart of shaders/chunks/occlude.glsl: the light that ambient occlusion takes. */

import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { vOcclusion } from './occlusion.js';

const { float, smoothstep } = tsl;
const { CAVITY, HOLLOW } = TONE_CONSTANTS;

/** Strength of ambient occlusion. */
const occlusion = /* @__PURE__ */ hatchingUniform('occlusion', 'float');
/** Tone of the deepest hollows. */
const hollowTone = /* @__PURE__ */ hatchingUniform('hollowTone', 'float');

/** The share of ambient light that is left. */
export const openToSky = (): Value => float(1).sub(occlusion.mul(vOcclusion));

/** The share of directed light that is left: little less than all, except where most of the sky is hidden. */
export const openToLights = (): Value => float(1).sub(occlusion.mul(vOcclusion).mul(smoothstep(0, CAVITY, vOcclusion)));

/** The darkness of deep hollows, which light does not lessen. */
export const hollowness = (): Value => hollowTone.mul(occlusion).mul(smoothstep(HOLLOW[0], HOLLOW[1], vOcclusion));
