import { type BufferGeometry, type IUniform, Matrix3, Matrix4, type Object3D, Vector3 } from 'three';

/** Under this name in `userData` of a mesh: the elements of the matrix from its object space to a frame it shares with others. */
export const FIELD_FRAME = 'hatchingField';

const frame = /* @__PURE__ */ new Matrix4();
const linear = /* @__PURE__ */ new Matrix3();
const origin = /* @__PURE__ */ new Vector3();

/**
 * Writes where the lines of `engraved` on a mesh count from, and in which frame: that which `applyHatching` gave a whole scene,
 * or else that of the object, from the centre of its bounding sphere. Allocates nothing.
 *
 * @param strokeScale tiles per unit of object space
 * @returns whether anything changed: three uploads the uniforms of a material once for all its meshes
 */
export function writeFieldFrame(
  uniforms: Record<string, IUniform>,
  strokeScale: number,
  geometry: BufferGeometry,
  { userData }: Object3D,
): boolean {
  const shared: unknown = userData[FIELD_FRAME];
  if (isMatrix(shared)) {
    linear.setFromMatrix4(frame.fromArray(shared));
    origin.setFromMatrixPosition(frame.invert());
  } else {
    linear.identity();
    // three has computed it where it culls.
    if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
    origin.copy(geometry.boundingSphere!.center);
  }
  linear.multiplyScalar(strokeScale);
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

/** Whether it is a matrix that can be inverted: `userData` may come from a file. */
const isMatrix = (value: unknown): value is number[] =>
  Array.isArray(value) &&
  value.length === 16 &&
  value.every(Number.isFinite) &&
  frame.fromArray(value).determinant() !== 0;
