import { Matrix3, Matrix4, type Mesh, Vector3 } from 'three';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { writeFieldFrame } from '../../material/parts/fieldFrame.js';
import type { EngravedLook } from '../Engraver.js';
import type { Mat3 } from '../shading/screenGradient.js';
import { firstBoneOf } from './posedVertices.js';

/** Matrices between a mesh, the world, the view and the space of fields. */
export interface SurfaceFrame {
  toWorld: Matrix4;
  toView: Matrix4;
  normalToWorld: Matrix3;
  fieldOrigin: Vector3;
  toField: Matrix3;
  normalToField: Matrix3;
  /** Transforms lines that are fixed to the surface at rest to world space, for the mesh as a whole. */
  restToWorld: Matrix4;
  /** Whether lines are laid on the deformed mesh, not on the mesh at rest. */
  isCutAsPosed: boolean;
  hasOcclusion: boolean;
}

/** Instances stand in different places, so occlusion is not baked for them. */
const hasOcclusion = (mesh: Mesh): boolean => !('isInstancedMesh' in mesh || 'isBatchedMesh' in mesh);

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
  // Lines that follow the form are fixed to the surface at rest, whatever `strokeAnchor` is.
  const isCutAsPosed = strokeAnchor === 'deformed' && !followsForm(lineField);
  const firstBone = isCutAsPosed ? null : firstBoneOf(mesh);
  return {
    toWorld,
    toView: new Matrix4().multiplyMatrices(worldToView, toWorld),
    normalToWorld: new Matrix3().getNormalMatrix(toWorld),
    restToWorld: firstBone ? firstBone.premultiply(toWorld) : toWorld,
    isCutAsPosed,
    hasOcclusion: hasOcclusion(mesh),
    fieldOrigin: fieldOrigin.value,
    toField: objectToField.value,
    normalToField: objectToFieldNormal.value,
  };
}

const followsForm = (lineField: EngravedLook['lineField']): boolean =>
  lineField === 'form' || lineField === 'acrossForm';

/** The same, with object space as the space of fields, for dots. */
export function objectFrame(mesh: Mesh, toWorld: Matrix4, worldToView: Matrix4): SurfaceFrame {
  return {
    toWorld,
    toView: new Matrix4().multiplyMatrices(worldToView, toWorld),
    normalToWorld: new Matrix3().getNormalMatrix(toWorld),
    restToWorld: toWorld,
    isCutAsPosed: false,
    hasOcclusion: hasOcclusion(mesh),
    fieldOrigin: new Vector3(),
    toField: new Matrix3(),
    normalToField: new Matrix3(),
  };
}

/** The rows of a matrix of three.js. */
export function rowsOf({ elements: e }: Matrix3): Mat3 {
  return [
    [e[0], e[3], e[6]],
    [e[1], e[4], e[7]],
    [e[2], e[5], e[8]],
  ];
}
