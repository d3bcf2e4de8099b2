import { NO_TWIN, triangleOf } from '../corners.js';
import { cutSharpEdges } from '../normals/cutSharpEdges.js';
import { findPatches } from '../normals/findPatches.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { Parts } from './findParts.js';

/** A patch smaller than a disc of this radius has no lines of its own. A share of the bounding radius of its part. */
const SMALLEST_RADIUS = 0.04;

/**
 * Chooses the creases that are borders of the field: the sharp edges between two patches that are both large enough for lines of their own.
 * Lines continue across all others: creases that end within a patch, such as the corner of a mouth, and the small patches of scans.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`)
 * @param radius the bounding radius of the mesh
 * @param parts the parts that `twins` connect
 * @returns a copy of `twins` with NO_TWIN at these creases
 */
export function* formTwins(
  twins: Int32Array<ArrayBuffer>,
  areaNormals: Float64Array<ArrayBuffer>,
  radius: number,
  parts: Parts,
): Generator<number, Int32Array<ArrayBuffer>, void> {
  const sharpTwins = twins.slice();
  yield* asPhase(cutSharpEdges(sharpTwins, areaNormals), 0, 0.7);
  const { ofTriangle, areas } = yield* asPhase(findPatches({ twins: sharpTwins, areaNormals }), 0.7, 0.9);
  const smallest = Math.PI * (SMALLEST_RADIUS * radius) ** 2;
  const isLarge = new Uint8Array(areas.length);
  yield* forEachChunk(ofTriangle.length, (start, end) => {
    for (let triangle = start; triangle < end; triangle++) {
      const patch = ofTriangle[triangle];
      isLarge[patch] = Number(areas[patch] >= smallest * parts.shares[parts.ofTriangle[triangle]] ** 2);
    }
  });
  const cut = twins.slice();
  yield* asPhase(
    forEachChunk(twins.length, (start, end) => cutRange(sharpTwins, ofTriangle, isLarge, cut, start, end)),
    0.9,
    1,
  );
  return cut;
}

/** Each half-edge is judged by itself. The two halves of an edge always get the same result. */
function cutRange(
  sharpTwins: Int32Array,
  ofTriangle: Uint32Array,
  isLarge: Uint8Array,
  cut: Int32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = cut[corner];
    if (twin === NO_TWIN || sharpTwins[corner] !== NO_TWIN) continue;
    const a = ofTriangle[triangleOf(corner)];
    const b = ofTriangle[triangleOf(twin)];
    if (a !== b && isLarge[a] === 1 && isLarge[b] === 1) cut[corner] = NO_TWIN;
  }
}
