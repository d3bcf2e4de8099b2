import type { Mesh } from 'three';
import { identityOf } from '../geometry/identityOf.js';

/** The identities of the marked meshes. */
const claimed = new WeakSet<object>();

/**
 * Marks meshes as hatched, or as being hatched, until the returned function is called. A second call of that does nothing.
 *
 * @throws Error if one of the meshes is already marked
 */
export function claimMeshes(meshes: readonly Mesh[]): () => void {
  const taken = meshes.find((mesh) => claimed.has(identityOf(mesh)));
  if (taken) {
    throw new Error(
      `applyHatching: the mesh "${taken.name || taken.uuid}" is hatched already, or is being hatched. Call restore() or dispose() of the result of the first call, then apply again.`,
    );
  }
  for (const mesh of meshes) claimed.add(identityOf(mesh));
  let held = meshes;
  return () => {
    for (const mesh of held) claimed.delete(identityOf(mesh));
    held = [];
  };
}
