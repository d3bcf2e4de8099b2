/** The twin of shaders/perFragment/emit.glsl: where strokes are anchored, for the vertex shader. */
import type { NodeBuilder } from 'three/webgpu';
import { identity, inverseOf } from '../base/matrices.js';
import { tsl, type Value } from '../base/values.js';
import type { DeformedVertex } from '../chunks/deformVertex.js';
import { strokeNormalOf } from '../chunks/hatchNormal.js';
import type { ObjectPlace } from '../chunks/objectToView.js';
import { rotationBetween } from './rotationBetween.js';
import { isRigid, vViewToAnchor } from './viewToAnchor.js';

const { normalGeometry, positionGeometry } = tsl;

/** What a vertex is anchored by. */
export interface Anchor extends ObjectPlace {
  /** Object space, at rest or deformed. */
  position: Value;
  /** At the scale of a stroke, in that space. */
  strokeNormal: Value;
  /** The linear part of what takes the deformed object to the one at rest; null where nothing deforms. */
  deformedToRest: Value | null;
  /** From the view to where strokes are anchored. Linear part. */
  viewToAnchor: Value;
}

function deformedToRestOf({ morphedNormal, skin }: DeformedVertex): Value | null {
  const unbent = skin && inverseOf(skin, identity());
  if (!morphedNormal) return unbent;
  // Morph targets move vertices, they turn nothing. What they do to the normal is all that is known here.
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
  // From the left is the transpose: what the inverse transpose of the deformation is to the normal.
  if (!isAtRest && deformedToRest) strokeNormal = strokeNormal.mul(deformedToRest).toVar();
  const position = isAtRest ? positionGeometry : deformed.position;
  return { ...place, position, strokeNormal, deformedToRest, viewToAnchor };
}
