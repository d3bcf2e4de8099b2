import type { HandStroke } from 'three-hatching';

/** The strokes without those that a rubber at a point touches; the same array if it touches none. Lengths are in millimetres. */
export function eraseStrokes(
  strokes: readonly HandStroke[],
  x: number,
  y: number,
  radius: number,
): readonly HandStroke[] {
  const left = strokes.filter((stroke) => !touches(stroke, x, y, radius));
  return left.length === strokes.length ? strokes : left;
}

function touches({ points, widths }: HandStroke, x: number, y: number, radius: number): boolean {
  for (let i = 0; i + 1 < widths.length; i++) {
    const [fromX, fromY, toX, toY] = [points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3]];
    const [dx, dy] = [toX - fromX, toY - fromY];
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - fromX) * dx + (y - fromY) * dy) / square : 0;
    const share = Math.min(1, Math.max(0, along));
    const width = widths[i] + share * (widths[i + 1] - widths[i]);
    if (Math.hypot(fromX + share * dx - x, fromY + share * dy - y) <= radius + width / 2) return true;
  }
  return false;
}
