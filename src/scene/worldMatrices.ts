import { type InstancedMesh, Matrix4, type Mesh, type SkinnedMesh } from 'three';

/**
 * The object-to-world matrix of a mesh, or of each of its instances. For a skinned mesh, which is drawn where its bones are,
 * the transform by the first bone. The world matrices of the scene must be up to date.
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

/** World units per object unit: the geometric mean over directions and matrices. 1 if all matrices are singular. */
export function worldScale(matrices: readonly Matrix4[]): number {
  const logarithms = matrices.map((matrix) => Math.log(Math.abs(matrix.determinant())) / 3).filter(Number.isFinite);
  if (logarithms.length === 0) return 1;
  return Math.exp(logarithms.reduce((sum, logarithm) => sum + logarithm, 0) / logarithms.length);
}
