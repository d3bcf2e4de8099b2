import { type InstancedMesh, Matrix4, type Mesh } from 'three';

/** The world matrices of a mesh: one, or one per instance. World matrices must be up to date. */
export function placements(mesh: Mesh): Matrix4[] {
  if (!('isInstancedMesh' in mesh)) return [mesh.matrixWorld];
  const instanced = mesh as InstancedMesh;
  return Array.from({ length: instanced.count }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(i, matrix);
    return matrix.premultiply(mesh.matrixWorld);
  });
}
