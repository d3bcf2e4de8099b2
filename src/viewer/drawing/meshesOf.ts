import type { Mesh, Object3D } from 'three';

/** All meshes at or below an object. */
export function meshesOf(root: Object3D): Mesh[] {
  return root.getObjectsByProperty('isMesh', true) as Mesh[];
}
