/** The space that strokes are anchored in: the object at rest, or deformed. */
import type { BufferGeometry } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { identity, inverseOf } from '../base/maths.js';
import { tsl, type Value } from '../base/values.js';
import { strokeNormalOf } from './occlusion.js';
import { type DeformedVertex, type ObjectPlace, viewToObject } from './vertex.js';

const { cross, dot, float, If, mat3, normalGeometry, normalize, positionGeometry, varyingProperty, vec3 } = tsl;

/**
 * Counterpart of shaders/perFragment/rotationBetween.glsl: the smallest rotation from one direction to another; the identity for null
 * vectors.
 */
export function rotationBetween(from: Value, to: Value): Value {
  const start = normalize(from).toVar();
  const end = normalize(to).toVar();
  const axis = cross(start, end).toVar();
  const cosine = dot(start, end).toVar();
  const rotation = identity().toVar();
  // For opposite directions no axis is better than another.
  If(cosine.greaterThan(-0.999), () => {
    const { x, y, z } = axis;
    const crossAxis = mat3(vec3(0, z, y.negate()), vec3(z.negate(), 0, x), vec3(y, x.negate(), 0)).toVar();
    const squared = crossAxis.mul(crossAxis).toVar();
    const share = float(1).div(cosine.add(1)).toVar();
    const column = (k: number): Value =>
      rotation.element(k).add(crossAxis.element(k)).add(squared.element(k).mul(share));
    rotation.assign(mat3(column(0), column(1), column(2)));
  });
  return rotation;
}

/** Counterpart of shaders/perFragment/viewToAnchor.glsl: the linear map from view space to the space of anchors. */

/** The matrix by columns, since nodes have no matrix varyings. */
const vViewToAnchor: readonly Value[] = /* @__PURE__ */ [0, 1, 2].map((column) =>
  varyingProperty('vec3', `vViewToAnchor${column}`),
);

/** Whether vertices move with their object alone, without skinning, morph targets or instances. */
export function isRigid({ object, geometry }: NodeBuilder): boolean {
  const { morphAttributes } = geometry as BufferGeometry;
  const moves = ['isSkinnedMesh', 'isInstancedMesh', 'isBatchedMesh'].some((kind) => kind in (object as object));
  return !moves && !morphAttributes.position && !morphAttributes.normal;
}

/** The matrix in the fragment shader. */
export const readViewToAnchor = (builder: NodeBuilder): Value =>
  isRigid(builder) ? viewToObject : mat3(...vViewToAnchor).toVar();

/** Counterpart of shaders/perFragment/emit.glsl: the anchor of strokes at a vertex. */

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
