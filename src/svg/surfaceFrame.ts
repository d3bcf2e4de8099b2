import { Matrix3, Matrix4, type Mesh, Vector3 } from 'three';
import { type Field, firstField } from '../engraving/fieldAxis.js';
import { fieldLight } from '../engraving/lightField.js';
import type { Lamp } from '../engraving/radiance.js';
import type { Vec3 } from '../engraving/vectors.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { writeFieldFrame } from '../material/parts/fieldFrame.js';
import type { EngravedLook } from '../vector/Engraver.js';
import { firstBoneOf } from './posedVertices.js';

/** Matrices between a mesh, the world, a view and the space that lines are cut in. */
export interface SurfaceFrame {
  toWorld: Matrix4;
  toView: Matrix4;
  normalToWorld: Matrix3;
  fieldOrigin: Vector3;
  toField: Matrix3;
  normalToField: Matrix3;
  /** Brings lines that are fixed to the surface at rest to the world, as the whole mesh has them. */
  restToWorld: Matrix4;
  /** Whether lines lie on the mesh as it is posed, not as it is at rest. */
  isCutAsPosed: boolean;
  /** Instances stand in many places, so no occlusion is baked for them. */
  hasOcclusion: boolean;
}

/** @param worldToView of the camera */
export function surfaceFrame(
  mesh: Mesh,
  toWorld: Matrix4,
  { tilesPerUnit, strokeAnchor }: HatchingMaterial,
  { lineField }: EngravedLook,
  worldToView: Matrix4,
): SurfaceFrame {
  const fieldOrigin = { value: new Vector3() };
  const objectToField = { value: new Matrix3() };
  const objectToFieldNormal = { value: new Matrix3() };
  writeFieldFrame({ fieldOrigin, objectToField, objectToFieldNormal }, tilesPerUnit, mesh.geometry, mesh);
  // Lines that follow the form are fixed to the surface, whatever strokes are.
  const isCutAsPosed = strokeAnchor === 'deformed' && !followsForm(lineField);
  const firstBone = isCutAsPosed ? null : firstBoneOf(mesh);
  return {
    toWorld,
    toView: new Matrix4().multiplyMatrices(worldToView, toWorld),
    normalToWorld: new Matrix3().getNormalMatrix(toWorld),
    restToWorld: firstBone ? firstBone.premultiply(toWorld) : toWorld,
    isCutAsPosed,
    hasOcclusion: !('isInstancedMesh' in mesh || 'isBatchedMesh' in mesh),
    fieldOrigin: fieldOrigin.value,
    toField: objectToField.value,
    normalToField: objectToFieldNormal.value,
  };
}

const followsForm = (lineField: EngravedLook['lineField']): lineField is 'form' | 'acrossForm' =>
  lineField === 'form' || lineField === 'acrossForm';

/** The field of the first family of lines on a mesh; null for those that follow the form. */
export function fieldOf(
  { lineField }: EngravedLook,
  { strokeRotation }: HatchingMaterial,
  lamps: readonly Lamp[],
  { restToWorld, fieldOrigin, toField }: SurfaceFrame,
): Field | null {
  if (followsForm(lineField)) return null;
  const toObject = new Matrix4().copy(restToWorld).invert();
  const seen = lamps.map(({ at, isFar, luminance }) => {
    const way = new Vector3(...at);
    if (isFar) way.transformDirection(toObject);
    else way.applyMatrix4(toObject).sub(fieldOrigin);
    return { toLight: way.applyMatrix3(toField).toArray() as Vec3, luminance, isFar };
  });
  return firstField(lineField, fieldLight(seen), strokeRotation);
}
