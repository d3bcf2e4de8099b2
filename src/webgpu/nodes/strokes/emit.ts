import { formLayout } from '../../../mesh/bake/attributeLayouts.js';
import { isOrthographic } from '../base/maths.js';
import { tsl, type Value } from '../base/values.js';
import type { Anchor } from '../chunks/anchor.js';
import { unitsPerPixel } from '../chunks/vertex.js';

const { attribute, modelViewMatrix, positionLocal, select, varyingProperty, vec3, vec4 } = tsl;

/** Counterpart of shaders/techniques/strokes/varyings.glsl. */

/** Object space. */
export const vRestPosition: Value = /* @__PURE__ */ varyingProperty('vec3', 'vRestPosition');
/** At the scale of a stroke, object space. */
export const vStrokeNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vStrokeNormal');
/** Object units to a pixel. */
export const vUnitsPerPixel: Value = /* @__PURE__ */ varyingProperty('float', 'vUnitsPerPixel');
/** Object space, of any length. */
export const vToViewer: Value = /* @__PURE__ */ varyingProperty('vec3', 'vToViewer');
/** Gradient of the function along whose level lines strokes run, object space, of any length. */
export const vFormSlope: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFormSlope');

/**
 * Counterpart of shaders/techniques/strokes/emit.glsl.
 *
 * @param look whether strokes follow the form, and whether they are anchored to the surface at rest
 */
export function emitStrokes(
  { position, strokeNormal, viewToAnchor, deformedToRest }: Anchor,
  { isOfForm, isAtRest }: { isOfForm: boolean; isAtRest: boolean },
): void {
  // three.js has applied the matrix of the instance already.
  const inView = modelViewMatrix.mul(vec4(positionLocal, 1)).xyz.toVar();
  vRestPosition.assign(position);
  vStrokeNormal.assign(strokeNormal);
  vUnitsPerPixel.assign(unitsPerPixel(viewToAnchor, inView));
  vToViewer.assign(viewToAnchor.mul(select(isOrthographic(), vec3(0, 0, 1), inView.negate())));
  if (!isOfForm) return;
  const slope = attribute(formLayout.slope.name, 'vec4').xyz;
  // A gradient transforms as a normal does.
  vFormSlope.assign(!isAtRest && deformedToRest ? slope.mul(deformedToRest) : slope);
}
