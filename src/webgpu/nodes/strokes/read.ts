/** The directions of strokes at a fragment. */
import type { Light } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { isInFullShadow, type ReceivedShadow } from '../base/lights.js';
import { isOrthographic, safeNormalize } from '../base/maths.js';
import { tsl, type Value } from '../base/values.js';
import { readViewToAnchor } from '../chunks/anchor.js';
import { anyTangent, followsForm, lightBitangent, strokeDirection } from '../chunks/lightOrientation.js';
import { vFormSlope, vRestPosition, vStrokeNormal, vToViewer } from './emit.js';

const { cross, dot, float, inverseSqrt, normalize, positionView, select, vec3 } = tsl;

/** The directions of strokes in the surface. */
export interface StrokeAxes {
  /** The strokes' u and v in the surface, object space. */
  uAxis: Value;
  vAxis: Value;
  /** The disagreement of the lights, from 0 to 1. */
  crossing: Value;
}

/** Counterpart of shaders/techniques/strokes/readForm.glsl: strokes along or across the level lines of a baked function. */

/** @param n unit normal, object space @param isDark true where no light arrives, where strokes run the other way; null if nowhere */
export function axesOfForm(n: Value, isAcross: boolean, isDark: Value | null): StrokeAxes {
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

/** Counterpart of shaders/techniques/strokes/readLight.glsl: strokes that follow the light. */

/** @param n unit normal, object space */
export function axesOfLight(
  n: Value,
  lights: readonly Light[],
  viewToAnchor: Value,
  receivedShadows: readonly ReceivedShadow[],
): StrokeAxes {
  const { bitangent, crossing } = lightBitangent(n, lights, viewToAnchor, receivedShadows);
  const tangent = cross(bitangent, n).toVar();
  const { x, y } = strokeDirection;
  return {
    uAxis: tangent.mul(x).add(bitangent.mul(y)).toVar(),
    vAxis: bitangent.mul(x).sub(tangent.mul(y)).toVar(),
    crossing,
  };
}

/** Counterpart of shaders/techniques/strokes/readSheet.glsl: strokes with a fixed direction on the sheet. */

/** @param n unit normal, object space */
export function axesOfSheet(n: Value, viewToAnchor: Value): StrokeAxes {
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

/** Counterpart of shaders/techniques/strokes/read.glsl: the frame of strokes, found per fragment so that it turns continuously. */

/** The parameters of hatching at a fragment. */
export interface HatchingParameters extends StrokeAxes {
  /** Object space. */
  point: Value;
  /** Unit, object space. */
  normal: Value;
  /** Components of the direction to the viewer along u, v and the normal, of any length. */
  lean: Value;
}

/** @param direction the choice @param receivedShadows lights that cast shadows */
export function readHatchingParameters(
  builder: NodeBuilder,
  lights: readonly Light[],
  direction: string,
  receivedShadows: readonly ReceivedShadow[],
): HatchingParameters {
  const n = safeNormalize(vStrokeNormal);
  const viewToAnchor = readViewToAnchor(builder);
  let axes: StrokeAxes;
  if (followsForm(direction)) axes = axesOfForm(n, direction === 'acrossForm', isInFullShadow(lights, receivedShadows));
  else if (direction === 'sheet') axes = axesOfSheet(n, viewToAnchor);
  else axes = axesOfLight(n, lights, viewToAnchor, receivedShadows);
  const lean = vec3(dot(vToViewer, axes.uAxis), dot(vToViewer, axes.vAxis), dot(vToViewer, n)).toVar();
  return { ...axes, point: vRestPosition.toVar(), normal: n, lean };
}
