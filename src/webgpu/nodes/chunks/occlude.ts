/** The twin of shaders/chunks/occlude.glsl: what ambient occlusion takes of the light. */

import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { vOcclusion } from './occlusion.js';

const { float, smoothstep } = tsl;
const { CAVITY, HOLLOW } = TONE_CONSTANTS;

/** How much of it counts. */
const occlusion = /* @__PURE__ */ hatchingUniform('occlusion', 'float');
/** How dark the depths of hollows are. */
const hollowTone = /* @__PURE__ */ hatchingUniform('hollowTone', 'float');

/** Light from all around loses the share of the sky that is hidden. */
export const openToSky = (): Value => float(1).sub(occlusion.mul(vOcclusion));

/** Light with a direction loses as much where much of the sky is hidden, and nearly nothing where little is. */
export const openToLights = (): Value => float(1).sub(occlusion.mul(vOcclusion).mul(smoothstep(0, CAVITY, vOcclusion)));

/** The depths of hollows are the darkest places of a drawing, also where light reaches them. */
export const hollowness = (): Value => hollowTone.mul(occlusion).mul(smoothstep(HOLLOW[0], HOLLOW[1], vOcclusion));
