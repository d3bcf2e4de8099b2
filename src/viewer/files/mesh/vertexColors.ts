import { Color, SRGBColorSpace } from 'three';
import type { PlainMesh } from './PlainMesh.js';

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
