import { type InstancedMesh, Matrix4, type Mesh, type SkinnedMesh } from 'three';

/**
 * Object to world, once for every time a mesh is drawn: the mesh itself or each of its instances. Of a skinned mesh, which
 * is drawn where its bones are, the placement by the first bone. World matrices must be up to date.
 */
export function worldMatrices(mesh: Mesh): Matrix4[] {
  if ('isInstancedMesh' in mesh) {
    const instanced = mesh as InstancedMesh;
    return Array.from({ length: instanced.count }, (_, i) => {
      const matrix = new Matrix4();
      instanced.getMatrixAt(i, matrix);
      return matrix.premultiply(mesh.matrixWorld);
    });
  }
  const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
  const [bone] = skeleton?.bones ?? [];
  if (bone === undefined) return [mesh.matrixWorld];
  const matrix = new Matrix4().multiplyMatrices(mesh.matrixWorld, bindMatrixInverse).multiply(bone.matrixWorld);
  return [matrix.multiply(skeleton.boneInverses[0]).multiply(bindMatrix)];
}

/** How many world units an object unit is, as the mean over directions and worldMatrices; 1 where nothing has a size. */
export function worldScale(matrices: readonly Matrix4[]): number {
  const logarithms = matrices.map((matrix) => Math.log(Math.abs(matrix.determinant())) / 3).filter(Number.isFinite);
  if (logarithms.length === 0) return 1;
  return Math.exp(logarithms.reduce((sum, logarithm) => sum + logarithm, 0) / logarithms.length);
}
