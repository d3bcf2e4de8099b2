import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { smoothstep } from '../../look/vectors.js';

/**
 * The share of directional light that reaches an occluded surface, as in `occlude.glsl`.
 *
 * @param occlusion the baked occlusion, from 0 to 1
 * @param strength the share of the occlusion that counts
 */
export const openToLamps = (occlusion: number, strength: number): number =>
  1 - strength * occlusion * smoothstep(0, TONE_CONSTANTS.CAVITY, occlusion);
