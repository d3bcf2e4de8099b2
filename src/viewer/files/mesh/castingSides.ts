import { openTriangles } from '../../../mesh/orientation/openTriangles.js';
import { runToEnd } from '../../../mesh/phases.js';
import type { TriangleMesh } from '../../../mesh/TriangleMesh.js';
import type { PictureRange, PlainMesh } from './PlainMesh.js';

/**
 * Marks the one-sided surfaces that are open or face inward: their fronts cast shadows, as they are what is seen. Others keep those of
 * their backs, the usual ones of three.js. Ranges with both are split, so that triangles change their order.
 */
export function withCastingSides(mesh: PlainMesh): PlainMesh {
  const { indices, ranges, isOneSided } = mesh;
  if (!indices || !(isOneSided || ranges?.some((range) => range.isOneSided))) return mesh;
  const isOpen = runToEnd(openTriangles(mesh as TriangleMesh));
  if (!isOpen.includes(1)) return mesh;
  if (!ranges && !isOpen.includes(0)) return { ...mesh, castsFronts: true };
  const sorted = indices.slice();
  const whole = { start: 0, count: indices.length, picture: -1, isOneSided: true };
  return {
    ...mesh,
    indices: sorted,
    ranges: (ranges ?? [whole]).flatMap((range) => split(range, isOpen, indices, sorted)),
  };
}

/** The closed and the open part of a range, whose triangles are sorted. */
function split(range: PictureRange, isOpen: Uint8Array, indices: Uint32Array, sorted: Uint32Array): PictureRange[] {
  if (!range.isOneSided) return [range];
  const { start, count } = range;
  let to = start;
  const write = (open: 0 | 1): number => {
    const first = to;
    for (let corner = start; corner < start + count; corner += 3) {
      if (isOpen[corner / 3] !== open) continue;
      for (let k = corner; k < corner + 3; k++) sorted[to++] = indices[k];
    }
    return to - first;
  };
  const closed = { ...range, count: write(0) };
  const open = { ...range, start: to, count: write(1), castsFronts: true };
  return [closed, open].filter((part) => part.count > 0);
}
