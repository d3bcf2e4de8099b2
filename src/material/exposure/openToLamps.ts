import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';

/**
 * The share of a light with a direction that hollows leave a surface, as `occlude.glsl` has it.
 *
 * @param occlusion as it was baked, from 0 to 1
 * @param strength how much of it counts
 */
export function openToLamps(occlusion: number, strength: number): number {
  const t = Math.min(1, occlusion / TONE_CONSTANTS.CAVITY);
  return 1 - strength * occlusion * t * t * (3 - 2 * t);
}
