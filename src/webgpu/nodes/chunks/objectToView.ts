/** Counterpart of shaders/chunks/objectToView.glsl: the matrices of the object, or of one of its instances. */
import type { BatchedMesh, InstancedMesh, Object3D, Texture } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { blankFloats } from '../base/blankTextures.js';
import { placesOf } from '../base/InstancePlaces.js';
import { inverseOf, linearPart } from '../base/matrices.js';
import { texelOf } from '../base/texelOf.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type TextureValue, threeNodes, tsl, type Value } from '../base/values.js';

const { batch, batchIndirectIndex, instancedMesh, instanceIndex, int, mat4, modelViewMatrix } = tsl;

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
  // A private name of three.js, by which its own materials read the texture.
  return 'isBatchedMesh' in object
    ? (object as BatchedMesh & { readonly _matricesTexture: Texture })._matricesTexture
    : null;
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
