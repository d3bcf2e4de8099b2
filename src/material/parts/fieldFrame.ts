import { type BufferGeometry, type IUniform, Matrix3, Matrix4, type Object3D, Vector3 } from 'three';
import { FIELD_FRAME } from '../fieldFrameName.js';

const frame = /* @__PURE__ */ new Matrix4();
const linear = /* @__PURE__ */ new Matrix3();
const origin = /* @__PURE__ */ new Vector3();

/**
 * Writes the origin and the frame of the lines of `engraved` on a mesh: the frame that `applyHatching` gave to the whole scene, or
 * else that of the object, with the centre of its bounding sphere as origin. Allocates nothing.
 *
 * @param tilesPerUnit tiles per unit of object space
 * @returns whether anything changed, in which case three must upload the uniforms again: by default it does so once for all meshes
 */
export function writeFieldFrame(
  uniforms: Record<string, IUniform>,
  tilesPerUnit: number,
  geometry: BufferGeometry,
  { userData }: Object3D,
): boolean {
  const shared: unknown = userData[FIELD_FRAME];
  if (isMatrix(shared)) {
    linear.setFromMatrix4(frame.fromArray(shared));
    origin.setFromMatrixPosition(frame.invert());
  } else {
    linear.identity();
    // three has computed the sphere already where it culls.
    if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
    origin.copy(geometry.boundingSphere!.center);
  }
  linear.multiplyScalar(tilesPerUnit);
  const { fieldOrigin, objectToField, objectToFieldNormal } = uniforms as {
    fieldOrigin: IUniform<Vector3>;
    objectToField: IUniform<Matrix3>;
    objectToFieldNormal: IUniform<Matrix3>;
  };
  if (objectToField.value.equals(linear) && fieldOrigin.value.equals(origin)) return false;
  fieldOrigin.value.copy(origin);
  objectToField.value.copy(linear);
  objectToFieldNormal.value.copy(linear).invert().transpose();
  return true;
}

/** Whether these are the elements of a matrix that can be inverted: `userData` may come from a file. */
const isMatrix = (value: unknown): value is number[] =>
  Array.isArray(value) &&
  value.length === 16 &&
  value.every(Number.isFinite) &&
  frame.fromArray(value).determinant() !== 0;
