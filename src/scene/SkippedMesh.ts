import type { Mesh } from 'three';

/** A mesh that was left unchanged, or hatched without the outlines that were requested. */
export interface SkippedMesh {
  mesh: Mesh;
  /** The reason, in a sentence that names the mesh. */
  reason: string;
  /** The cause, if the mesh should have been hatched and could not be. */
  error?: Error | undefined;
}
