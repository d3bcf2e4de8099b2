/** The vertex as three.js moves it: by bones, morph targets and instances. */
import type { BufferGeometry, InstancedMesh, Object3D, SkinnedMesh, Texture } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { batchMatrices } from '../../../material/three/batches.js';
import { placesOf } from '../../outlines/instancePlaces.js';
import { inverseOf, isOrthographic, linearPart } from '../base/maths.js';
import { blankFloats, hatchingUniform, texelOf } from '../base/uniforms.js';
import { type TextureValue, threeNodes, tsl, type Value } from '../base/values.js';

const { abs, add, attribute, batch, batchIndirectIndex, cameraProjectionMatrix, determinant, instancedMesh } = tsl;
const { instanceIndex, int, mat4, modelViewMatrix, morphReference, normalLocal, positionLocal, pow, reference } = tsl;
const { referenceBuffer, select, skinning } = tsl;

/** Counterpart of shaders/chunks/deformVertex.glsl: deforms the vertex as three.js' materials do. */

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

/** Counterpart of shaders/chunks/objectToView.glsl: the matrices of the object, or of one of its instances. */

/** Linear part of the inverse model-view matrix, for objects without instances. */
export const viewToObject: Value = /* @__PURE__ */ hatchingUniform('viewToObject', 'mat3');

/** Placeholder for objects without instances or batches. */
const noPlaces = /* @__PURE__ */ blankFloats();
/** Matrices of instances or of a batch, one column per texel. */
const instancePlaces = /* @__PURE__ */ threeNodes
  .uniformTexture(noPlaces)
  .onObjectUpdate(({ object }) => placesTexture(object as Object3D) ?? noPlaces) as unknown as TextureValue;

function placesTexture(object: Object3D): Texture | null {
  if ('isInstancedMesh' in object) return placesOf(object as InstancedMesh);
  return batchMatrices(object);
}

function placeOf(instance: Value): Value {
  const first = int(instance).mul(4).toVar();
  return mat4(...[0, 1, 2, 3].map((column) => instancePlaces.load(texelOf(first.add(column), instancePlaces)))).toVar();
}

/** The transform of an object or instance. */
export interface ObjectPlace {
  objectToView: Value;
  /** Linear part. */
  viewToObject: Value;
}

/** Moves the vertex by the matrix of its instance, as three.js' materials do, and returns the transform. */
export function placeInstance({ object }: NodeBuilder): ObjectPlace {
  const { isBatchedMesh, isInstancedMesh } = object as { isBatchedMesh?: boolean; isInstancedMesh?: boolean };
  if (!isBatchedMesh && !isInstancedMesh) return { objectToView: modelViewMatrix, viewToObject };
  if (isBatchedMesh) batch(object);
  if (isInstancedMesh) instancedMesh(object);
  const objectToView = modelViewMatrix.mul(placeOf(isBatchedMesh ? batchIndirectIndex : instanceIndex)).toVar();
  return { objectToView, viewToObject: inverseOf(linearPart(objectToView)) };
}

/** Counterpart of shaders/chunks/unitsPerPixel.glsl. */

const viewportHeight = /* @__PURE__ */ hatchingUniform('viewportHeight', 'float');

/** Object units per pixel at a vertex. @param viewToObject linear part */
export function unitsPerPixel(viewToObject: Value, viewPosition: Value): Value {
  const away = select(isOrthographic(), 1, viewPosition.z.negate());
  // The cube root of the determinant: the mean scale over directions.
  const scale = pow(abs(determinant(viewToObject)), 1 / 3);
  return away
    .mul(scale)
    .mul(2)
    .div(abs(cameraProjectionMatrix.element(1).element(1)).mul(viewportHeight));
}
