import { isInk, type SurfaceImage } from './SurfaceImage.js';
import { structureTensor } from './structureTensor.js';

/**
 * The length of the way along strokes within the ink, in pixels: the median over all pixels of ink, of the way
 * forward and backward together. Ways that end where the surface does are left out, since nobody knows how long those
 * strokes are. The direction is that of the structure tensor; every pixel further, one may step a pixel aside.
 *
 * @returns NaN where there is no such way
 */
export function strokeLength(image: SurfaceImage): number {
  const { width, height, luminance, surface } = image;
  const { xx, xy, yy } = structureTensor(image);
  const longest = width + height;

  /** Pixels to the end of the ink; NaN where the surface ends first. */
  const wayFrom = (start: number, sense: number): number => {
    let [x, y] = [start % width, Math.floor(start / width)];
    let [dx, dy] = [0, 0];
    for (let way = 0; way < longest; way++) {
      const here = Math.round(y) * width + Math.round(x);
      // Across the direction in which luminance changes most.
      const angle = 0.5 * Math.atan2(2 * xy[here], xx[here] - yy[here]) + Math.PI / 2;
      const along = [Math.cos(angle), Math.sin(angle)] as const;
      const sign = (way === 0 ? sense : dx * along[0] + dy * along[1]) < 0 ? -1 : 1;
      [dx, dy] = [sign * along[0], sign * along[1]];
      let found = false;
      for (const aside of [0, 1, -1]) {
        const [nx, ny] = [x + dx - aside * dy, y + dy + aside * dx];
        const [column, row] = [Math.round(nx), Math.round(ny)];
        if (column < 0 || row < 0 || column >= width || row >= height) return Number.NaN;
        const next = row * width + column;
        if (surface[next] === 0) return Number.NaN;
        if (!isInk(luminance[next])) continue;
        [x, y] = [nx, ny];
        found = true;
        break;
      }
      if (!found) return way;
    }
    return longest;
  };

  const lengths: number[] = [];
  for (let i = 0; i < luminance.length; i++) {
    if (surface[i] === 0 || !isInk(luminance[i])) continue;
    const length = 1 + wayFrom(i, 1) + wayFrom(i, -1);
    if (!Number.isNaN(length)) lengths.push(length);
  }
  return lengths.sort((a, b) => a - b)[Math.floor(lengths.length / 2)] ?? Number.NaN;
}
