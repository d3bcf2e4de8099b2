/** Counterpart of shaders/techniques/anchored/readForm.glsl: strokes along or across the level lines of a baked function. */

import { tsl, type Value } from '../base/values.js';
import { anyTangent } from '../chunks/lightOrientation.js';
import type { StrokeAxes } from './StrokeAxes.js';
import { vFormSlope } from './varyings.js';

const { cross, dot, float, inverseSqrt, normalize, select } = tsl;

/** @param n unit normal, object space @param isDark true where no light arrives, where strokes run the other way; null if nowhere */
export function readStrokeAxes(n: Value, isAcross: boolean, isDark: Value | null): StrokeAxes {
  const level = cross(n, vFormSlope).toVar();
  const squaredLength = dot(level, level).toVar();
  // At a singular point of the field any direction will do.
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
