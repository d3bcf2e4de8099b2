/** Counterpart of shaders/techniques/anchored/emit.glsl. */
import { formLayout } from '../../../mesh/bake/attributeLayouts.js';
import { isOrthographic } from '../base/isOrthographic.js';
import { tsl } from '../base/values.js';
import { unitsPerPixel } from '../chunks/unitsPerPixel.js';
import type { Anchor } from '../perFragment/emit.js';
import { vFormSlope, vRestPosition, vStrokeNormal, vToViewer, vUnitsPerPixel } from './varyings.js';

const { attribute, modelViewMatrix, positionLocal, select, vec3, vec4 } = tsl;

/** @param look whether strokes follow the form, and whether they are anchored to the surface at rest */
export function emitAnchored(
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
