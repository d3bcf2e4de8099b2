import { type InstancedMesh, Matrix4, type Mesh, type SkinnedMesh } from 'three';

/**
 * The object-to-world matrix of a mesh, or one for each of its instances. A skinned mesh is drawn where its bones are, so its matrix is
 * that of the first bone. The world matrices of the scene must be up to date.
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

/** The number of world units per object unit, as the geometric mean over directions and matrices; 1 if all matrices are singular. */
export function worldScale(matrices: readonly Matrix4[]): number {
  const logarithms = matrices.map((matrix) => Math.log(Math.abs(matrix.determinant())) / 3).filter(Number.isFinite);
  if (logarithms.length === 0) return 1;
  return Math.exp(logarithms.reduce((sum, logarithm) => sum + logarithm, 0) / logarithms.length);
}
