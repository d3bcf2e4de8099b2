/** Counterpart of shaders/techniques/anchored/readSheet.glsl: strokes with a fixed direction on the sheet. */

import { isOrthographic } from '../base/isOrthographic.js';
import { strokeDirection } from '../base/strokeDirection.js';
import { tsl, type Value } from '../base/values.js';
import { anyTangent } from '../chunks/lightOrientation.js';
import type { StrokeAxes } from './StrokeAxes.js';

const { cross, dot, float, inverseSqrt, normalize, positionView, select, vec3 } = tsl;

/** @param n unit normal, object space */
export function readStrokeAxes(n: Value, viewToAnchor: Value): StrokeAxes {
  const toViewer = select(isOrthographic(), vec3(0, 0, 1), positionView.negate()).toVar();
  // The intersection of the surface with the plane through the eye and a slanted line of the sheet.
  const inView = cross(n.mul(viewToAnchor), cross(vec3(strokeDirection, 0), toViewer)).toVar();
  const along = viewToAnchor.mul(inView).toVar();
  const squaredLength = dot(along, along).toVar();
  const uAxis = select(
    squaredLength.greaterThan(0),
    along.mul(inverseSqrt(squaredLength)),
    normalize(anyTangent(n)),
  ).toVar();
  return { uAxis, vAxis: cross(n, uAxis).toVar(), crossing: float(0) };
}
