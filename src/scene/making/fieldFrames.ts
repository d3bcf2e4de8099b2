import { Matrix4, type Mesh, type Object3D, type Vector3 } from 'three';
import { isBatched } from '../surfaceMeshes.js';
import { worldMatrices, worldScale } from '../worldMatrices.js';

/**
 * Returns a function that computes the matrix from the object space of a mesh to a coordinate frame that all meshes share: the
 * frame of `root`, with its origin in a common centre. Engraved lines in this frame continue from mesh to mesh. Its unit is that
 * of the mesh's object space, because `tilesPerUnit` refers to that. Instanced and batched meshes, and meshes with a singular
 * matrix, have no such frame.
 *
 * @param centre the centre of all meshes, in world space
 */
export function fieldFrames(root: Object3D, centre: Vector3): (mesh: Mesh) => number[] | undefined {
  const rootScale = worldScale([root.matrixWorld]);
  const worldToRoot = root.matrixWorld.clone().invert();
  const origin = centre.clone().applyMatrix4(worldToRoot);
  const isRootFlat = root.matrixWorld.determinant() === 0;
  return (mesh) => {
    if (isRootFlat || 'isInstancedMesh' in mesh || isBatched(mesh)) return undefined;
    const matrices = worldMatrices(mesh);
    if (matrices[0].determinant() === 0) return undefined;
    const scale = rootScale / worldScale(matrices);
    return new Matrix4()
      .makeScale(scale, scale, scale)
      .multiply(new Matrix4().makeTranslation(-origin.x, -origin.y, -origin.z))
      .multiply(worldToRoot)
      .multiply(matrices[0])
      .toArray();
  };
}
