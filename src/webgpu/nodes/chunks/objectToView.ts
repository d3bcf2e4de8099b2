/** The twin of shaders/chunks/objectToView.glsl: the matrices of the object, or of one of its instances. */
import type { BatchedMesh, InstancedMesh, Object3D, Texture } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { blankFloats } from '../base/blankTextures.js';
import { placesOf } from '../base/InstancePlaces.js';
import { inverseOf, linearPart } from '../base/matrices.js';
import { texelOf } from '../base/texelOf.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type TextureValue, threeNodes, tsl, type Value } from '../base/values.js';

const { batch, batchIndirectIndex, instancedMesh, instanceIndex, int, mat4, modelViewMatrix } = tsl;

/** Of an object without instances, the same for all its vertices. Linear part. */
export const viewToObject: Value = /* @__PURE__ */ hatchingUniform('viewToObject', 'mat3');

/** Of an object that has neither. */
const noPlaces = /* @__PURE__ */ blankFloats();
/** Matrices of instances or of what a batch holds, a column to a texel. */
const instancePlaces = /* @__PURE__ */ threeNodes
  .uniformTexture(noPlaces)
  .onObjectUpdate(({ object }) => placesTexture(object as Object3D) ?? noPlaces) as unknown as TextureValue;

function placesTexture(object: Object3D): Texture | null {
  if ('isInstancedMesh' in object) return placesOf(object as InstancedMesh);
  // The name is three's own, and no part of its documented interface; materials of three.js read it by that name.
  return 'isBatchedMesh' in object
    ? (object as BatchedMesh & { readonly _matricesTexture: Texture })._matricesTexture
    : null;
}

function placeOf(instance: Value): Value {
  const first = int(instance).mul(4).toVar();
  return mat4(...[0, 1, 2, 3].map((column) => instancePlaces.load(texelOf(first.add(column), instancePlaces)))).toVar();
}

/** Where vertices of one object lie in the view. */
export interface ObjectPlace {
  objectToView: Value;
  /** Linear part. */
  viewToObject: Value;
}

/** Puts the vertex to the place of its instance, as three's own materials do, and says where that is. */
export function placeInstance({ object }: NodeBuilder): ObjectPlace {
  const { isBatchedMesh, isInstancedMesh } = object as { isBatchedMesh?: boolean; isInstancedMesh?: boolean };
  if (!isBatchedMesh && !isInstancedMesh) return { objectToView: modelViewMatrix, viewToObject };
  if (isBatchedMesh) batch(object);
  if (isInstancedMesh) instancedMesh(object);
  const objectToView = modelViewMatrix.mul(placeOf(isBatchedMesh ? batchIndirectIndex : instanceIndex)).toVar();
  return { objectToView, viewToObject: inverseOf(linearPart(objectToView)) };
}
