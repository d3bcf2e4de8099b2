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

/** Object space as the space of fields, for dots. worldToView: of the camera. */
export const objectFrame = (mesh: Mesh, toWorld: Matrix4, worldToView: Matrix4): SurfaceFrame => ({
  toWorld,
  toView: new Matrix4().multiplyMatrices(worldToView, toWorld),
  normalToWorld: new Matrix3().getNormalMatrix(toWorld),
  restToWorld: toWorld,
  isCutAsPosed: false,
  // Instances stand in different places, so occlusion is not baked for them.
  hasOcclusion: !('isInstancedMesh' in mesh || 'isBatchedMesh' in mesh),
  fieldOrigin: new Vector3(),
  toField: new Matrix3(),
  normalToField: new Matrix3(),
});

/** The space of the lines of a material. */
export function surfaceFrame(
  mesh: Mesh,
  toWorld: Matrix4,
  { tilesPerObjectUnit, strokeAnchor }: HatchingMaterial,
  { direction }: EngravedLook,
  worldToView: Matrix4,
): SurfaceFrame {
  const frame = objectFrame(mesh, toWorld, worldToView);
  const [fieldOrigin, objectToField, objectToFieldNormal] = [frame.fieldOrigin, frame.toField, frame.normalToField].map(
    (value) => ({ value }),
  );
  writeFieldFrame({ fieldOrigin, objectToField, objectToFieldNormal }, tilesPerObjectUnit, mesh.geometry, mesh);
  // Lines that follow the form are fixed to the surface at rest, whatever `strokeAnchor` is.
  const isCutAsPosed = strokeAnchor === 'deformed' && !followsForm(direction);
  const firstBone = isCutAsPosed ? null : firstBoneOf(mesh);
  return { ...frame, isCutAsPosed, restToWorld: firstBone ? firstBone.premultiply(toWorld) : toWorld };
}

export const followsForm = (direction: EngravedLook['direction']): direction is 'form' | 'acrossForm' =>
  direction === 'form' || direction === 'acrossForm';

/** The rows of a matrix of three.js. */
export function rowsOf({ elements: e }: Matrix3): Mat3 {
  return [
    [e[0], e[3], e[6]],
    [e[1], e[4], e[7]],
    [e[2], e[5], e[8]],
  ];
}
