import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';

/**
 * The share of directional light that reaches an occluded surface, as in `occlude.glsl`.
 *
 * @param occlusion the baked occlusion, from 0 to 1
 * @param strength the share of the occlusion that counts
 */
export function openToLamps(occlusion: number, strength: number): number {
  const t = Math.min(1, occlusion / TONE_CONSTANTS.CAVITY);
  return 1 - strength * occlusion * t * t * (3 - 2 * t);
}
