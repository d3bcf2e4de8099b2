import type { SurfaceImage } from './SurfaceImage.js';

/**
 * The unevenness of a surface of even tone: the standard deviation of its darkness, blurred over a few strokes. Seams, bands and
 * clumps of strokes count; single strokes do not.
 *
 * @param image a picture that the surface fills
 * @param blur the standard deviation of the Gaussian blur, in pixels
 * @returns the deviation, of tones from 0 to 1
 */
export function unevenness({ width, height, luminance }: SurfaceImage, blur: number): number {
  const reach = Math.ceil(2.5 * blur);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-((i - reach) ** 2) / (2 * blur ** 2)));
  const total = weights.reduce((sum, weight) => sum + weight);
  const [innerWidth, innerHeight] = [width - 2 * reach, height - 2 * reach];
  // Pixels near the edges of the picture do not count.
  const rows = new Float64Array(innerWidth * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < innerWidth; x++) {
      let sum = 0;
      for (let i = 0; i < weights.length; i++) sum += weights[i] * (1 - luminance[y * width + x + i]);
      rows[y * innerWidth + x] = sum / total;
    }
  }
  let [sum, squares] = [0, 0];
  for (let y = 0; y < innerHeight; y++) {
    for (let x = 0; x < innerWidth; x++) {
      let tone = 0;
      for (let i = 0; i < weights.length; i++) tone += weights[i] * rows[(y + i) * innerWidth + x];
      tone /= total;
      sum += tone;
      squares += tone * tone;
    }
  }
  const count = innerWidth * innerHeight;
  return Math.sqrt(Math.max(squares / count - (sum / count) ** 2, 0));
}
