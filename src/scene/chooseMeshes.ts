import type { Mesh } from 'three';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { leftAlone } from './leftAlone.js';
import type { SkippedMesh } from './SkippedMesh.js';
import { isClaimed } from './surfaceMeshes.js';

/** The greatest number of meshes that an error names. */
const MAX_NAMED = 3;

/** The meshes of a scene, divided into those to hatch and the others. */
export interface ChosenMeshes {
  chosen: Mesh[];
  /** Meshes that stay hatched as they are. */
  kept: Mesh[];
  /** Meshes that are left alone on purpose. */
  skipped: SkippedMesh[];
  /** Meshes that others have hatched, or are hatching. They are among the skipped ones. */
  claimed: Mesh[];
}

/** What has hatched meshes. */
export interface MeshHolder {
  /** Whether it has hatched a mesh. */
  holds(mesh: Mesh): boolean;
  /** Whether a mesh that it has hatched stays as it is. */
  keeps(mesh: Mesh): boolean;
}

/**
 * Divides meshes into those to hatch and those to leave alone.
 *
 * @param holder what holds the meshes that are hatched already
 */
export function chooseMeshes(meshes: readonly Mesh[], holder: MeshHolder | undefined): ChosenMeshes {
  const choice: ChosenMeshes = { chosen: [], kept: [], skipped: [], claimed: [] };
  for (const mesh of meshes) {
    const why = leftAlone(mesh);
    if (why !== undefined) {
      choice.skipped.push({ mesh, reason: `The ${describeObject(mesh)} is left alone: ${why}.` });
    } else if (holder?.holds(mesh)) {
      (holder.keeps(mesh) ? choice.kept : choice.chosen).push(mesh);
    } else if (isClaimed(mesh)) {
      choice.claimed.push(mesh);
      choice.skipped.push({ mesh, reason: `The ${describeObject(mesh)} is hatched already, or is being hatched.` });
    } else choice.chosen.push(mesh);
  }
  return choice;
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
