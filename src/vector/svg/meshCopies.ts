import { type BatchedMesh, Color, type InstancedMesh, Matrix4, type Mesh } from 'three';
import { isScaledToNothing } from '../../material/outlines/surfaceRules.js';

/** A placement of a mesh: its own, or that of an instance. */
export interface MeshCopy {
  toWorld: Matrix4;
  /** Index of the instance; −1 for a mesh without instances. */
  instance: number;
  /** Factor on the colours of the mesh, linear light; null for none. */
  tint: readonly [r: number, g: number, b: number] | null;
  /** The part of the geometry that is drawn, in corners; null for all. */
  range: { start: number; count: number } | null;
}

/** All placements of a mesh, except those hidden by a scale of 0. */
export const meshCopies = (mesh: Mesh): MeshCopy[] =>
  allCopies(mesh).filter(({ toWorld }) => !isScaledToNothing(toWorld));

function allCopies(mesh: Mesh): MeshCopy[] {
  if ('isBatchedMesh' in mesh) return batchCopies(mesh as BatchedMesh);
  if (!('isInstancedMesh' in mesh)) return [{ toWorld: mesh.matrixWorld, instance: -1, tint: null, range: null }];
  const { count, instanceColor } = mesh as InstancedMesh;
  return Array.from({ length: count }, (_, instance) => {
    const toWorld = new Matrix4();
    (mesh as InstancedMesh).getMatrixAt(instance, toWorld);
    const tint = instanceColor
      ? ([0, 1, 2].map((k) => instanceColor.getComponent(instance, k)) as [number, number, number])
      : null;
    return { toWorld: toWorld.premultiply(mesh.matrixWorld), instance, tint, range: null };
  });
}

function batchCopies(batch: BatchedMesh): MeshCopy[] {
  const copies: MeshCopy[] = [];
  const color = new Color();
  let left = batch.instanceCount;
  for (let instance = 0; left > 0 && instance < batch.maxInstanceCount; instance++) {
    const toWorld = new Matrix4();
    if (!isThere(batch, instance)) continue;
    left--;
    if (!batch.getVisibleAt(instance)) continue;
    batch.getMatrixAt(instance, toWorld).premultiply(batch.matrixWorld);
    const range = batch.getGeometryRangeAt(batch.getGeometryIdAt(instance));
    if (!range) continue;
    batch.getColorAt(instance, color);
    const isTinted = color.r !== 1 || color.g !== 1 || color.b !== 1;
    const tint = isTinted ? ([color.r, color.g, color.b] as const) : null;
    copies.push({ toWorld, instance, tint, range: { start: range.start, count: range.count } });
  }
  return copies;
}

/** Whether an instance exists: three.js throws an error for deleted ones. */
function isThere(batch: BatchedMesh, instance: number): boolean {
  try {
    batch.getVisibleAt(instance);
    return true;
  } catch {
    return false;
  }
}
