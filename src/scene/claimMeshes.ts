import type { Mesh } from 'three';
import { identityOf } from '../material/geometry/identityOf.js';

/** The identities of the claimed meshes. */
const claimed = new WeakSet<object>();

/** Whether a mesh, or a proxy of it, is hatched or being hatched. */
export const isClaimed = (mesh: Mesh): boolean => claimed.has(identityOf(mesh));

/** Marks meshes as hatched, or as being hatched, until the returned function is called. A second call of that function does nothing. */
export function claimMeshes(meshes: readonly Mesh[]): () => void {
  for (const mesh of meshes) claimed.add(identityOf(mesh));
  let held = meshes;
  return () => {
    for (const mesh of held) claimed.delete(identityOf(mesh));
    held = [];
  };
}
