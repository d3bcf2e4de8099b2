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

/** What the bones of a vertex do, from object space to object space. */
function skinMatrixOf({ skeleton }: SkinnedMesh): Value {
  const bones = referenceBuffer('skeleton.boneMatrices', 'mat4', skeleton.bones.length);
  const index = attribute('skinIndex', 'uvec4');
  const weight = attribute('skinWeight', 'vec4');
  const parts = (['x', 'y', 'z', 'w'] as const).map((c) => bones.element(index[c]).mul(weight[c]));
  const sum = parts.reduce((a, b) => add(a, b));
  return reference('bindMatrixInverse', 'mat4').mul(sum).mul(reference('bindMatrix', 'mat4')).toVar();
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
