import { Box3, type Mesh, type Object3D } from 'three';
import { SceneExtent } from '../../material/fading/SceneExtent.js';
import type { MeshLook } from '../MeshLook.js';
import { isBatched } from '../surfaceMeshes.js';
import { worldMatrices } from '../worldMatrices.js';

/** How far all meshes reach, in the space of `root`. It yields after each of them. */
export function* extentOf(root: Object3D, looks: readonly (MeshLook | Mesh)[]): Generator<number, SceneExtent, void> {
  const extent = new SceneExtent(root);
  const toRoot = root.matrixWorld.clone().invert();
  for (const look of looks) {
    const { mesh, geometry } = 'isMesh' in look ? { mesh: look, geometry: look.geometry } : look;
    const bounds = boundsOf(mesh, geometry);
    for (const matrix of worldMatrices(mesh))
      extent.box.union(bounds.clone().applyMatrix4(matrix.clone().premultiply(toRoot)));
    yield 0;
  }
  return extent;
}

function boundsOf(mesh: Mesh, { boundingBox, boundingSphere }: Mesh['geometry']): Box3 {
  if (isBatched(mesh)) return mesh.boundingSphere!.getBoundingBox(new Box3());
  return boundingBox ?? boundingSphere!.getBoundingBox(new Box3());
}
