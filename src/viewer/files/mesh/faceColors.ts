import type { PlainMesh } from './PlainMesh.js';

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
