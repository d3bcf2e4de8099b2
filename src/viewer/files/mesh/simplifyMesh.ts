import type { Simplifier } from '../../../mesh/detail/loadSimplifier.js';
import { type SimplifiableMesh, simplifyTriangles } from '../../../mesh/detail/simplifyTriangles.js';
import { compact } from './cleanMesh.js';
import type { PlainMesh } from './PlainMesh.js';

/** Meshes with more triangles are simplified, since a sheet cannot show more. */
const MOST_TRIANGLES = 1_500_000;
/** The first error limit, in radii: half a pixel on a sheet of 1,000 pixels. It is raised if the result has too many triangles. */
const FIRST_ERROR = 2 ** -10;
/**
 * Two passes: the second simplifies across the borders of the first one's cells. The first leaves twice the target, so that both
 * contribute.
 */
const PASSES = [
  { shift: 0, leaves: 2 },
  { shift: 0.5, leaves: 1 },
];
/** The distance that counts as much as a full change of colour. */
const COLOR_WEIGHT = 0.05;

/** A simplified mesh, and its maximum deviation from the original in radii. */
export interface SimplifiedMesh {
  mesh: PlainMesh;
  error: number;
}

/**
 * Simplifies a mesh of radius 1 without pictures to at most `most` triangles, each of its ranges separately.
 *
 * @param onProgress called with rising numbers in [0, 1]
 * @param most maximum number of triangles
 */
export function simplifyMesh(
  mesh: PlainMesh,
  simplifier: Simplifier,
  onProgress: (progress: number) => void,
  most = MOST_TRIANGLES,
): SimplifiedMesh {
  const { positions, colors } = mesh;
  const source: SimplifiableMesh = {
    positions,
    attributes: colors ?? new Float32Array(),
    weights: colors ? new Array<number>(3).fill(COLOR_WEIGHT) : [],
  };
  const indices = mesh.indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const ranges = mesh.ranges ?? [{ start: 0, count: indices.length, picture: -1 }];
  let parts = ranges.map(({ start, count }) => indices.slice(start, start + count));
  const count = (): number => parts.reduce((sum, { length }) => sum + length, 0);
  let error = 0;
  let progress = 0;
  for (let allowed = FIRST_ERROR; allowed < 0.1 && count() > 3 * most; allowed *= 2) {
    for (const { shift, leaves } of PASSES) {
      const share = Math.min(1, (3 * leaves * most) / count());
      let farthest = 0;
      parts = parts.map((part, i) => {
        const task = simplifyTriangles(source, part, allowed / 2, simplifier, shift, share);
        let step = task.next();
        // The number of passes is unknown; each is shorter than the previous one.
        for (; !step.done; step = task.next())
          onProgress(progress + (0.5 * (1 - progress) * (i + step.value)) / parts.length);
        farthest = Math.max(farthest, step.value.error);
        return step.value.indices;
      });
      progress += 0.5 * (1 - progress);
      error += farthest;
    }
  }
  return { mesh: joined(mesh, parts), error };
}

/** A mesh of the remaining triangles of each range. */
function joined(mesh: PlainMesh, parts: readonly Uint32Array[]): PlainMesh {
  const indices = new Uint32Array(parts.reduce((sum, { length }) => sum + length, 0));
  let start = 0;
  const ranges = parts.map(({ length: count }, i) => {
    indices.set(parts[i], start);
    start += count;
    return { ...mesh.ranges?.[i], start: start - count, count, picture: -1 };
  });
  return { ...compact(mesh, indices), ...(mesh.ranges && { ranges }) };
}
