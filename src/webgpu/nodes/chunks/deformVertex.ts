/** The twin of shaders/chunks/deformVertex.glsl: three deforms the vertex, with all that its own materials know. */
import type { BufferGeometry, SkinnedMesh } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { linearPart } from '../base/matrices.js';
import { tsl, type Value } from '../base/values.js';

const { add, attribute, morphReference, normalLocal, positionLocal, reference, referenceBuffer, skinning } = tsl;

/** A vertex in its present pose, object space. */
export interface DeformedVertex {
  position: Value;
  /** Its normal after morph targets and before skins; null where none turn it. */
  morphedNormal: Value | null;
  /** The linear part of what its bones do, null without bones. */
  skin: Value | null;
}

/** The matrices of the bones of the mesh that is drawn, in the space that it was bound in. */
export const bonesOf = ({ skeleton }: SkinnedMesh): Value =>
  referenceBuffer('skeleton.boneMatrices', 'mat4', skeleton.bones.length);

/** What a matrix in the space that a mesh was bound in does in object space. */
export const inObjectSpace = (bone: Value): Value =>
  reference('bindMatrixInverse', 'mat4').mul(bone).mul(reference('bindMatrix', 'mat4')).toVar();

/** What the bones of a vertex do, from object space to object space. */
function skinMatrixOf(mesh: SkinnedMesh): Value {
  const bones = bonesOf(mesh);
  const index = attribute('skinIndex', 'uvec4');
  const weight = attribute('skinWeight', 'vec4');
  const parts = (['x', 'y', 'z', 'w'] as const).map((c) => bones.element(index[c]).mul(weight[c]));
  return inObjectSpace(parts.reduce((a, b) => add(a, b)));
}

export function deformVertex(builder: NodeBuilder): DeformedVertex {
  const object = builder.object as SkinnedMesh;
  const { morphAttributes } = builder.geometry as BufferGeometry;
  if (morphAttributes.position || morphAttributes.normal || morphAttributes.color) morphReference(object);
  const morphedNormal = morphAttributes.normal ? normalLocal.toVar() : null;
  let skin: Value | null = null;
  if (object.isSkinnedMesh) {
    skin = linearPart(skinMatrixOf(object));
    skinning(object);
  }
  return { position: positionLocal.toVar(), morphedNormal, skin };
}
