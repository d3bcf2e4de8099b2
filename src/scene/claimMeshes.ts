import type { Mesh } from 'three';
import { identityOf } from '../geometry/identityOf.js';

/** Identities of meshes. */
const claimed = new WeakSet<object>();

/**
 * Marks meshes as hatched, or about to be, until the returned function is called. Calling that again does nothing.
 *
 * @throws Error if one of them is already marked
 */
export function claimMeshes(meshes: readonly Mesh[]): () => void {
  const taken = meshes.find((mesh) => claimed.has(identityOf(mesh)));
  if (taken) {
    throw new Error(
      `applyHatching: the mesh "${taken.name || taken.uuid}" is hatched already, or is being hatched. Call restore() or dispose() of what the first call resolves with, then apply again.`,
    );
  }
  for (const mesh of meshes) claimed.add(identityOf(mesh));
  let held = meshes;
  return () => {
    for (const mesh of held) claimed.delete(identityOf(mesh));
    held = [];
  };
}
