import { type BufferGeometry, type IUniform, Matrix3, Matrix4, type Object3D, Vector3 } from 'three';
import { FIELD_FRAME } from '../fieldFrameName.js';

const matrix = /* @__PURE__ */ new Matrix4();

/** A frame that lines are computed in: the matrix to it from object space, and what is derived from the matrix. */
interface FieldFrame {
  /** The elements of the matrix. */
  readonly elements: Float64Array;
  /** Whether the matrix can be inverted. */
  isUsable: boolean;
  /** The tiles per unit of object space that the matrices below were computed for; 0 before that. */
  tilesPerObjectUnit: number;
  /** To the frame, in tiles. */
  readonly linear: Matrix3;
  /** The inverse transpose of `linear`, for normals. */
  readonly normal: Matrix3;
  readonly origin: Vector3;
}

const newFrame = (): FieldFrame => ({
  elements: Float64Array.from(matrix.identity().elements),
  isUsable: true,
  tilesPerObjectUnit: 0,
  linear: new Matrix3(),
  normal: new Matrix3(),
  origin: new Vector3(),
});

const ofObject = /* @__PURE__ */ newFrame();

/** Keyed by the array in `userData`: thousands of meshes may have one, and in most frames none of them changes. */
const frames = /* @__PURE__ */ new WeakMap<readonly number[], FieldFrame>();

/**
 * Writes the origin and the frame of the lines on a mesh: the frame that `applyHatching` gave to the whole scene, or else
 * that of the object, with the centre of its bounding sphere as origin. Allocates nothing for a frame that is cached.
 *
 * @param tilesPerObjectUnit tiles per unit of object space
 * @returns whether anything changed, in which case three must upload these uniforms again: by default it does so once for all meshes
 */
export function writeFieldFrame(
  uniforms: Record<string, IUniform>,
  tilesPerObjectUnit: number,
  geometry: BufferGeometry,
  { userData }: Object3D,
): boolean {
  const frame = sharedFrame(userData[FIELD_FRAME]) ?? frameOfObject(geometry);
  if (frame.tilesPerObjectUnit !== tilesPerObjectUnit) scale(frame, tilesPerObjectUnit);
  const { linear, normal, origin } = frame;
  const { fieldOrigin, objectToField, objectToFieldNormal } = uniforms as {
    fieldOrigin: IUniform<Vector3>;
    objectToField: IUniform<Matrix3>;
    objectToFieldNormal: IUniform<Matrix3>;
  };
  if (objectToField.value.equals(linear) && fieldOrigin.value.equals(origin)) return false;
  fieldOrigin.value.copy(origin);
  objectToField.value.copy(linear);
  objectToFieldNormal.value.copy(normal);
  return true;
}

function frameOfObject(geometry: BufferGeometry): FieldFrame {
  // three.js has already computed the sphere if it culls the mesh.
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  ofObject.origin.copy(geometry.boundingSphere!.center);
  return ofObject;
}

/** The frame from `userData`, which may come from a file; undefined if the value is not a matrix. */
function sharedFrame(given: unknown): FieldFrame | undefined {
  if (!Array.isArray(given) || given.length !== 16) return undefined;
  let frame = frames.get(given);
  if (frame === undefined) frame = addFrame(given);
  else if (!isOf(frame, given)) read(frame, given);
  return frame.isUsable ? frame : undefined;
}

function addFrame(given: readonly number[]): FieldFrame {
  const frame = newFrame();
  read(frame, given);
  frames.set(given, frame);
  return frame;
}

/** Whether the array still has the elements that were read from it. */
function isOf({ elements }: FieldFrame, given: readonly number[]): boolean {
  for (let i = 0; i < 16; i++) if (elements[i] !== given[i]) return false;
  return true;
}

function read(frame: FieldFrame, given: readonly number[]): void {
  frame.elements.set(given);
  frame.isUsable = given.every(Number.isFinite) && matrix.fromArray(given).determinant() !== 0;
  if (frame.isUsable) frame.origin.setFromMatrixPosition(matrix.invert());
  frame.tilesPerObjectUnit = 0;
}

function scale(frame: FieldFrame, tilesPerObjectUnit: number): void {
  frame.linear.setFromMatrix4(matrix.fromArray(frame.elements)).multiplyScalar(tilesPerObjectUnit);
  frame.normal.copy(frame.linear).invert().transpose();
  frame.tilesPerObjectUnit = tilesPerObjectUnit;
}
