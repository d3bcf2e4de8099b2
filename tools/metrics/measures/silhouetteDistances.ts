import type { LocatedImage } from './reprojectedChange.js';

/** Two neighbouring pixels are separated by a silhouette if what they show lies farther apart than this, in pixels. */
const APART = 8;

/** The distance of every pixel to the nearest silhouette, in pixels: to where the surface ends, or hides what is behind it. The border of the picture is one. */
export function silhouetteDistances({ width, height, surface, places, objectToClip: m }: LocatedImage): Float32Array {
  const distances = new Float32Array(width * height).fill(Number.POSITIVE_INFINITY);
  const isApart = (i: number, k: number): boolean => {
    const [x, y, z] = [places[4 * i], places[4 * i + 1], places[4 * i + 2]];
    const away = Math.hypot(places[4 * k] - x, places[4 * k + 1] - y, places[4 * k + 2] - z);
    const pixelsPerUnit = (Math.hypot(m[1], m[5], m[9]) * height) / 2 / (m[3] * x + m[7] * y + m[11] * z + m[15]);
    return away * pixelsPerUnit > APART;
  };
  for (let i = 0; i < distances.length; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    if (surface[i] === 0 || x === 0 || y === 0 || x === width - 1 || y === height - 1) distances[i] = 0;
    else if ([i - 1, i - width].some((k) => surface[k] !== 0 && isApart(i, k))) distances[i] = 0;
  }
  // Two passes with steps to the sides and to the corners (Borgefors 1986).
  const lower = (i: number, steps: readonly number[]): void => {
    for (const [k, step] of steps.entries())
      distances[i] = Math.min(distances[i], distances[i + step] + (k < 2 ? 1 : Math.SQRT2));
  };
  for (let y = 1; y < height - 1; y++)
    for (let x = 1; x < width - 1; x++) lower(y * width + x, [-1, -width, -width - 1, 1 - width]);
  for (let y = height - 2; y > 0; y--)
    for (let x = width - 2; x > 0; x--) lower(y * width + x, [1, width, width + 1, width - 1]);
  return distances;
}
