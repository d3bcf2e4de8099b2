/** The twin of shaders/techniques/anchored/readForm.glsl: strokes along or across the level lines of a function that was baked into the vertices. */

import { tsl, type Value } from '../base/values.js';
import { anyTangent } from '../chunks/lightOrientation.js';
import type { StrokeAxes } from './StrokeAxes.js';
import { vFormSlope } from './varyings.js';

const { cross, dot, float, inverseSqrt, normalize, select } = tsl;

/** @param n unit normal, object space @param isDark where no light arrives, whose strokes run the other way; null if that is nowhere */
export function readStrokeAxes(n: Value, isAcross: boolean, isDark: Value | null): StrokeAxes {
  const level = cross(n, vFormSlope).toVar();
  const squaredLength = dot(level, level).toVar();
  // Any direction will do at a singular point.
  const along = select(
    squaredLength.greaterThan(0),
    level.mul(inverseSqrt(squaredLength)),
    normalize(anyTangent(n)),
  ).toVar();
  const across = cross(n, along);
  const [here, inTheDark] = isAcross ? [across, along] : [along, across];
  const uAxis = (isDark ? select(isDark, inTheDark, here) : here).toVar();
  return { uAxis, vAxis: cross(n, uAxis).toVar(), crossing: float(0) };
}
