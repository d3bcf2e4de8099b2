/** The twin of shaders/chunks/lineCoverage.glsl. */
import { type Input, tsl, type Value } from '../base/values.js';

const { clamp, max, min } = tsl;

/**
 * How much of a pixel a line covers, all in pixels.
 *
 * @param away from its centre
 * @param fringe how far its edge fades beyond its width
 */
export const lineCoverage = (away: Value, halfWidth: Value, fringe: Input): Value =>
  // A line thinner than a pixel is drawn as wide as one and as much lighter, so that it fades instead of breaking.
  clamp(max(halfWidth, 0.5).add(fringe).sub(away), 0, 1).mul(min(halfWidth.mul(2), 1));
