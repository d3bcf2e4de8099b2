/** Counterpart of shaders/chunks/deformVertex.glsl: deforms the vertex as three.js' materials do. */
import type { BufferGeometry, SkinnedMesh } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { linearPart } from '../base/matrices.js';
import { tsl, type Value } from '../base/values.js';

const { add, attribute, morphReference, normalLocal, positionLocal, reference, referenceBuffer, skinning } = tsl;

/** A deformed vertex, object space. */
export interface DeformedVertex {
  position: Value;
  /** The normal after morph targets and before skinning; null if none change it. */
  morphedNormal: Value | null;
  /** The linear part of the skinning matrix; null without bones. */
  skin: Value | null;
}

/** The bone matrices of the current mesh, in bind space. */
export const bonesOf = ({ skeleton }: SkinnedMesh): Value =>
  referenceBuffer('skeleton.boneMatrices', 'mat4', skeleton.bones.length);

/** Transforms a matrix from bind space to object space. */
export const inObjectSpace = (bone: Value): Value =>
  reference('bindMatrixInverse', 'mat4').mul(bone).mul(reference('bindMatrix', 'mat4')).toVar();

/** The skinning matrix of a vertex, object space. */
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
