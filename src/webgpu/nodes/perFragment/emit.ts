/** Counterpart of shaders/perFragment/emit.glsl: the anchor of strokes at a vertex. */
import type { NodeBuilder } from 'three/webgpu';
import { identity, inverseOf } from '../base/matrices.js';
import { tsl, type Value } from '../base/values.js';
import type { DeformedVertex } from '../chunks/deformVertex.js';
import { strokeNormalOf } from '../chunks/hatchNormal.js';
import type { ObjectPlace } from '../chunks/objectToView.js';
import { rotationBetween } from './rotationBetween.js';
import { isRigid, vViewToAnchor } from './viewToAnchor.js';

const { normalGeometry, positionGeometry } = tsl;

/** The anchor of strokes at a vertex. */
export interface Anchor extends ObjectPlace {
  /** Object space, at rest or deformed. */
  position: Value;
  /** The normal smoothed to the scale of a stroke, in the same space. */
  strokeNormal: Value;
  /** Linear part of the transform from the deformed object to the object at rest; null without deformation. */
  deformedToRest: Value | null;
  /** Linear part of the transform from the view to the space of anchors. */
  viewToAnchor: Value;
}

function deformedToRestOf({ morphedNormal, skin }: DeformedVertex): Value | null {
  const unbent = skin && inverseOf(skin, identity());
  if (!morphedNormal) return unbent;
  // Morph targets give no rotation of their own: it is taken from the change of the normal.
  const turned = rotationBetween(morphedNormal, normalGeometry);
  return unbent ? turned.mul(unbent).toVar() : turned;
}

/** @param isAtRest whether strokes are anchored to the surface at rest */
export function emitAnchor(
  builder: NodeBuilder,
  deformed: DeformedVertex,
  place: ObjectPlace,
  isAtRest: boolean,
): Anchor {
  const deformedToRest = deformedToRestOf(deformed);
  const { viewToObject } = place;
  const viewToAnchor = isAtRest && deformedToRest ? deformedToRest.mul(viewToObject).toVar() : viewToObject;
  if (!isRigid(builder)) {
    for (const [column, varying] of vViewToAnchor.entries()) varying.assign(viewToAnchor.element(column));
  }
  let strokeNormal = strokeNormalOf(builder).toVar();
  // Multiplied from the left, that is by the transpose: the inverse transpose of the deformation, as normals need.
  if (!isAtRest && deformedToRest) strokeNormal = strokeNormal.mul(deformedToRest).toVar();
  const position = isAtRest ? positionGeometry : deformed.position;
  return { ...place, position, strokeNormal, deformedToRest, viewToAnchor };
}
