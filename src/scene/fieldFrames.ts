import { Matrix4, type Mesh, type Object3D, type Vector3 } from 'three';
import { isBatched } from './surfaceMeshes.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/**
 * Tells the matrix from the object space of each mesh to one frame for all: that of `root`, from a common centre, in units as large
 * as those of the mesh, since `strokeScale` counts in them. Lines cut in this frame run on from mesh to mesh. Meshes of many
 * instances and those that are squeezed flat have none.
 *
 * @param centre of all meshes, world space
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
