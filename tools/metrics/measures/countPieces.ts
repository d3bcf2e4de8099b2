import { isInk, type SurfaceImage } from './SurfaceImage.js';

/** Number of pieces of ink and of paper on 10,000 pixels, and the median size of each, in pixels. */
export interface PieceCounts {
  ink: number;
  inkArea: number;
  paper: number;
  paperArea: number;
}

/**
 * Counts the dots of a tone, and the specks of paper that are left between them where they have grown together. Pieces join at sides
 * and not at corners.
 */
export function countPieces({ width, luminance }: SurfaceImage): PieceCounts {
  const areas: Record<'ink' | 'paper', number[]> = { ink: [], paper: [] };
  const seen = new Uint8Array(luminance.length);
  for (let start = 0; start < luminance.length; start++) {
    if (seen[start]) continue;
    const kind = isInk(luminance[start]);
    const piece = [start];
    seen[start] = 1;
    for (let next = 0; next < piece.length; next++) {
      const i = piece[next];
      const column = i % width;
      const sides = [column > 0 ? i - 1 : -1, column + 1 < width ? i + 1 : -1, i - width, i + width];
      for (const side of sides) {
        if (side < 0 || side >= luminance.length || seen[side] || isInk(luminance[side]) !== kind) continue;
        seen[side] = 1;
        piece.push(side);
      }
    }
    areas[kind ? 'ink' : 'paper'].push(piece.length);
  }
  const perArea = 10_000 / luminance.length;
  const middle = (values: number[]): number => values.sort((a, b) => a - b)[values.length >> 1] ?? 0;
  return {
    ink: areas.ink.length * perArea,
    inkArea: middle(areas.ink),
    paper: areas.paper.length * perArea,
    paperArea: middle(areas.paper),
  };
}
