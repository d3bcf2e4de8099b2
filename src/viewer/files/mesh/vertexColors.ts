import { Color, SRGBColorSpace } from 'three';
import { type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';

/**
 * Converts sRGB triples to linear RGB in [0, 1]. NaN becomes white.
 *
 * @param full the value of full brightness
 */
export function linearColors(values: ArrayLike<number>, full: number): Float32Array {
  const linear = new Float32Array(values.length);
  const color = new Color();
  const share = (value: number): number => (Number.isFinite(value) ? Math.min(Math.max(value / full, 0), 1) : 1);
  for (let i = 0; i < values.length; i += 3) {
    color.setRGB(share(values[i]), share(values[i + 1]), share(values[i + 2]), SRGBColorSpace).toArray(linear, i);
  }
  return linear;
}

/** Linear RGB per triangle. */
export type FaceColors = Float32Array;

/** Gives every corner its own vertex, with the colour of its face. */
export function withFaceColors({ positions, normals, indices }: PlainMesh, faceColors: FaceColors): PlainMesh {
  const pick = (source: Float32Array): Float32Array => {
    const picked = new Float32Array(3 * indices!.length);
    indices!.forEach((vertex, corner) => {
      for (let i = 0; i < 3; i++) picked[3 * corner + i] = source[3 * vertex + i] ?? NaN;
    });
    return picked;
  };
  const colors = new Float32Array(3 * indices!.length);
  for (let i = 0; i < colors.length; i++) colors[i] = faceColors[3 * Math.floor(i / 9) + (i % 3)] ?? 1;
  return { positions: pick(positions), normals: normals && pick(normals), colors, indices: null };
}

/** Surfaces with lower opacity are invisible. */
export const LEAST_ALPHA = 0.02;
/** Surfaces with at least this opacity are opaque. */
export const OPAQUE_ALPHA = 0.95;

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
  const isThere = (alpha: number): boolean => alpha >= LEAST_ALPHA;
  if (alphas.every((alpha) => alpha >= OPAQUE_ALPHA) || !alphas.some(isThere)) return mesh;
  const { indices } = mesh;
  const kept = new Uint32Array(3 * alphas.filter(isThere).length);
  const ranges: PictureRange[] = [];
  let corner = 0;
  for (const isSeeThrough of [false, true]) {
    const start = corner;
    for (let triangle = 0; triangle < total; triangle++) {
      if (!isThere(alphas[triangle]) || alphas[triangle] < OPAQUE_ALPHA !== isSeeThrough) continue;
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

/** The value of full brightness: 1 for fractions, 255 for integers. */
export function fullValue(values: ArrayLike<number>): number {
  for (let i = 0; i < values.length; i++) if (values[i] > 1) return 255;
  return 1;
}
