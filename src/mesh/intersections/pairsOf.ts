import { boxesMeet } from './TriangleTree.js';

/** Most triangles of a mesh whose lines are looked for. Scans are larger, and of one part. */
export const MOST_TRIANGLES = 2 ** 20;

/** Most pairs of meshes. */
const MOST_PAIRS = 2 ** 18;

/** Each mesh with itself, and the pairs whose boxes meet: a sweep along the axis on which they are spread farthest. */
export function pairsOf(boxes: readonly (Float64Array | null)[]): (readonly [number, number])[] {
  const known = boxes.flatMap((box, i) => (box ? [i] : []));
  const pairs: (readonly [number, number])[] = known.map((i) => [i, i]);
  const axis = [0, 1, 2].reduce((best, one) => (spreadOf(boxes, one) > spreadOf(boxes, best) ? one : best));
  known.sort((i, j) => boxes[i]![axis] - boxes[j]![axis]);
  for (const [at, i] of known.entries()) {
    for (let k = at + 1; k < known.length && boxes[known[k]]![axis] <= boxes[i]![axis + 3]; k++) {
      if (pairs.length >= MOST_PAIRS) return pairs;
      const j = known[k];
      if (boxesMeet(boxes[i]!, 0, boxes[j]!, 0)) pairs.push(i < j ? [i, j] : [j, i]);
    }
  }
  return pairs;
}

/** The variance of the centres of boxes along an axis. */
function spreadOf(boxes: readonly (Float64Array | null)[], axis: number): number {
  const centres = boxes.flatMap((box) => (box ? [box[axis] + box[axis + 3]] : []));
  const mean = centres.reduce((sum, value) => sum + value, 0) / Math.max(centres.length, 1);
  return centres.reduce((sum, value) => sum + (value - mean) ** 2, 0);
}
