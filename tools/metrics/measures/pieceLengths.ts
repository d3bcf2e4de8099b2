import type { SurfaceImage } from './SurfaceImage.js';

/** The luminance below which a pixel belongs to a stroke: the ends of strokes are thinner than a pixel, and cover little of it. */
const TOUCHED = 0.75;

/** A separate stroke: its length and its area, in pixels. */
export interface Piece {
  length: number;
  area: number;
}

/**
 * All separate strokes: pieces of ink, joined at sides and corners. The length of one is its extent along its major axis,
 * that of its second moments. Pieces that reach where the surface ends are left out, since nobody knows how long those strokes are.
 */
export function pieceLengths({ width, height, luminance, surface }: SurfaceImage): Piece[] {
  const isOn = (i: number): boolean => surface[i] !== 0 && luminance[i] < TOUCHED;
  const seen = new Uint8Array(luminance.length);
  const pieces: Piece[] = [];
  for (let start = 0; start < luminance.length; start++) {
    if (seen[start] || !isOn(start)) continue;
    const piece = [start];
    seen[start] = 1;
    let isWhole = true;
    for (let next = 0; next < piece.length; next++) {
      const [x, y] = [piece[next] % width, Math.floor(piece[next] / width)];
      for (let row = y - 1; row <= y + 1; row++) {
        for (let column = x - 1; column <= x + 1; column++) {
          const i = row * width + column;
          if (column < 0 || row < 0 || column >= width || row >= height || surface[i] === 0) isWhole = false;
          else if (!seen[i] && isOn(i)) {
            seen[i] = 1;
            piece.push(i);
          }
        }
      }
    }
    if (isWhole) pieces.push({ length: extent(piece, width), area: piece.length });
  }
  return pieces;
}

/** The extent of pixels along their major axis. */
function extent(piece: readonly number[], width: number): number {
  let [x, y, xx, xy, yy] = [0, 0, 0, 0, 0];
  for (const i of piece) {
    const [column, row] = [i % width, Math.floor(i / width)];
    x += column;
    y += row;
    xx += column * column;
    xy += column * row;
    yy += row * row;
  }
  const count = piece.length;
  const angle = 0.5 * Math.atan2(2 * (xy - (x * y) / count), xx - (x * x) / count - yy + (y * y) / count);
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const i of piece) {
    const along = (i % width) * dx + Math.floor(i / width) * dy;
    least = Math.min(least, along);
    most = Math.max(most, along);
  }
  return most - least + 1;
}
