/** Counterpart of shaders/chunks/lineCoverage.glsl. */
import { type Input, tsl, type Value } from '../base/values.js';

const { clamp, max, min } = tsl;

/**
 * The share of a pixel that a line covers; lengths in pixels.
 *
 * @param away distance from its centre
 * @param fringe how far its edge fades beyond its width
 */
export const lineCoverage = (away: Value, halfWidth: Value, fringe: Input): Value =>
  // A line thinner than a pixel is drawn one pixel wide and paler, so that it does not break up.
  clamp(max(halfWidth, 0.5).add(fringe).sub(away), 0, 1).mul(min(halfWidth.mul(2), 1));
