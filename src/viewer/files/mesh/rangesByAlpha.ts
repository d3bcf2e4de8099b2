import { type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';

/** Surfaces with lower opacity are invisible. */
export const LEAST = 0.02;
/** Surfaces with at least this opacity are opaque. */
export const MOST = 0.95;

/**
 * Sorts the triangles of a mesh without pictures by alpha into opaque, glass (in a range of its own) and invisible. If nothing would be
 * visible, all is opaque: some programs write alpha that they do not use.
 *
 * @param alphaOf a triangle, in [0, 1]
 */
export function rangesByAlpha(mesh: PlainMesh, alphaOf: (triangle: number) => number): PlainMesh {
  const total = triangleCount(mesh);
  const alphas = new Float32Array(total);
  for (let triangle = 0; triangle < total; triangle++) alphas[triangle] = alphaOf(triangle);
  const isThere = (alpha: number): boolean => alpha >= LEAST;
  if (alphas.every((alpha) => alpha >= MOST) || !alphas.some(isThere)) return mesh;
  const { indices } = mesh;
  const kept = new Uint32Array(3 * alphas.filter(isThere).length);
  const ranges: PictureRange[] = [];
  let corner = 0;
  for (const isSeeThrough of [false, true]) {
    const start = corner;
    for (let triangle = 0; triangle < total; triangle++) {
      if (!isThere(alphas[triangle]) || alphas[triangle] < MOST !== isSeeThrough) continue;
      for (let k = 3 * triangle; k < 3 * triangle + 3; k++) kept[corner++] = indices ? indices[k] : k;
    }
    const count = corner - start;
    if (count > 0) ranges.push({ start, count, picture: -1, ...(isSeeThrough && { isSeeThrough }) });
  }
  return { ...mesh, indices: kept, ...(ranges.some(({ isSeeThrough }) => isSeeThrough) && { ranges }) };
}

/** The mean alpha of a triangle's vertices. NaN counts as opaque. */
export const meanAlpha =
  (alphas: ArrayLike<number>, indices: ArrayLike<number> | null) =>
  (triangle: number): number => {
    let sum = 0;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const alpha = alphas[indices ? indices[corner] : corner];
      sum += Number.isFinite(alpha) ? alpha / 3 : 1 / 3;
    }
    return sum;
  };
