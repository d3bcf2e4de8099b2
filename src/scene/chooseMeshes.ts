import type { Mesh } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';
import type { HatchedScene, SkippedMesh } from './HatchedScene.js';
import { leftAlone } from './leftAlone.js';
import { isClaimed } from './surfaceMeshes.js';

/** The greatest number of meshes that an error names. */
const MAX_NAMED = 3;

/** The meshes of a scene, divided into those to hatch and the others. */
export interface ChosenMeshes {
  chosen: Mesh[];
  /** Meshes that are left alone on purpose. */
  skipped: SkippedMesh[];
  /** Meshes that are hatched already, or are being hatched. They are among the skipped ones. */
  claimed: Mesh[];
}

/**
 * Divides meshes into those to hatch and those to leave alone.
 *
 * @param replaces the hatched scene that is replaced: its meshes are hatched again
 * @throws Error that lists the meshes, if there are any and all of them are left alone
 */
export function chooseMeshes(meshes: readonly Mesh[], replaces: HatchedScene | undefined): ChosenMeshes {
  const chosen: Mesh[] = [];
  const skipped: SkippedMesh[] = [];
  const claimed: Mesh[] = [];
  for (const mesh of meshes) {
    const why = leftAlone(mesh);
    if (why !== undefined) {
      skipped.push({ mesh, reason: `The ${describeObject(mesh)} is left alone: ${why}.` });
    } else if (isClaimed(mesh) && !replaces?.holds(mesh)) {
      claimed.push(mesh);
      skipped.push({ mesh, reason: `The ${describeObject(mesh)} is hatched already, or is being hatched.` });
    } else chosen.push(mesh);
  }
  if (chosen.length === 0 && skipped.length > 0) {
    const remedy =
      claimed.length > 0
        ? 'Call restore() or dispose() of the result of the first call, or pass it as replaces.'
        : 'Set userData.hatching to true on what is to be hatched all the same.';
    throw new Error(`applyHatching: nothing is left to hatch. ${sentencesOf(skipped)} ${remedy}`);
  }
  return { chosen, skipped, claimed };
}

/** The reasons of the first few meshes, and the number of further ones. */
export function sentencesOf(skipped: readonly SkippedMesh[]): string {
  const more = skipped.length - MAX_NAMED;
  const sentences = skipped.slice(0, MAX_NAMED).map(({ reason }) => reason);
  if (more > 0) sentences.push(`So ${more === 1 ? 'is one more mesh' : `are ${more} more meshes`}.`);
  return sentences.join(' ');
}

/** The function name at the beginning of an error message. */
const CALLER = /^\w+: /;

/** A mesh that could not be read or prepared, with a sentence that names it. */
export function failure(mesh: Mesh, error: Error): SkippedMesh {
  return { mesh, reason: `The ${describeObject(mesh)} is left as it is: ${error.message.replace(CALLER, '')}`, error };
}
