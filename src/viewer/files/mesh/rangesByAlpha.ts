import { type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';

/** A surface with less opacity is not seen. */
export const LEAST = 0.02;
/** A surface with no less opacity hides what is behind it. */
export const MOST = 0.95;

/**
 * Settles how the triangles of a mesh without pictures are drawn, by their alpha: as opaque; as glass, in a range of its own; or not at all. Where
 * nothing would be seen, all is opaque: some programs write an alpha that they do not use.
 *
 * @param alphaOf a triangle, from 0 to 1
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

/** The mean alpha of a triangle's vertices. A value that is not a number is opaque. */
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
