import type { TriangleMesh } from '../TriangleMesh.js';
import { sideVotes } from './sideVotes.js';

/** The share of backs from which on a surface counts as seen from behind: that of a room whose walls face inward is 1, that of a sheet 0.5. */
const MOSTLY = 0.8;

/** Whether most that is seen of a mesh from around it are the backs of its triangles. */
export function* isSeenFromBehind(mesh: TriangleMesh): Generator<number, boolean, void> {
  const triangles = mesh.indices.length / 3;
  // All triangles as one patch, as they are.
  const patches = {
    patchOf: new Uint32Array(triangles),
    turned: new Uint8Array(triangles),
    isClosed: [false],
    doubleAreas: [1],
  };
  const whole = { isClosed: false, least: [], most: [], volume: 0, doubleArea: 1, samples: [] };
  const { front, back } = yield* sideVotes(mesh, patches, [whole]);
  return back[0] > MOSTLY * (front[0] + back[0]);
}
