import { runToEnd } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { sideVotes } from './sideVotes.js';

/** The share of what is seen of a mesh from around it that shows the back of its triangles. */
export function seenFromBehind(mesh: TriangleMesh): number {
  const triangles = mesh.indices.length / 3;
  // All triangles as one patch, as they are.
  const patches = {
    patchOf: new Uint32Array(triangles),
    turned: new Uint8Array(triangles),
    isClosed: [false],
    doubleAreas: [1],
  };
  const whole = { isClosed: false, least: [], most: [], volume: 0, doubleArea: 1, samples: [] };
  const { front, back } = runToEnd(sideVotes(mesh, patches, [whole]));
  return back[0] / Math.max(1, front[0] + back[0]);
}
