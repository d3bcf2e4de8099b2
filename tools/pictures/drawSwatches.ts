import type { Hand, HandStroke } from 'three-hatching';

/** The width of three swatches on the sheet, in millimetres. */
const SHEET = 66;
/** The upper edge of the swatches and their name below it, in shares of the width. */
const TOP = 0.07;

/** Draws the strokes of a hand as they are on their sheet, with its name above. */
export function drawSwatches(
  context: CanvasRenderingContext2D,
  { name = '', strokes }: Hand,
  width: number,
  ink: string,
): void {
  const scale = width / SHEET;
  context.fillStyle = ink;
  context.font = `${Math.round(0.033 * width)}px Georgia, 'DejaVu Serif', serif`;
  context.textAlign = 'center';
  context.fillText(name, 0.5 * width, 0.045 * width);
  context.save();
  context.translate(0, TOP * width);
  context.scale(scale, scale);
  for (const stroke of strokes) drawStroke(context, stroke);
  context.restore();
}

/** A stroke as the area between round pens at its points. */
function drawStroke(context: CanvasRenderingContext2D, { points, widths }: HandStroke): void {
  for (let i = 0; i < widths.length; i++) {
    const [x, y] = [points[2 * i], points[2 * i + 1]];
    context.beginPath();
    context.arc(x, y, 0.5 * widths[i], 0, 2 * Math.PI);
    context.fill();
    if (i === 0) continue;
    const [beforeX, beforeY] = [points[2 * i - 2], points[2 * i - 1]];
    const length = Math.hypot(x - beforeX, y - beforeY);
    if (length === 0) continue;
    const [sideX, sideY] = [(beforeY - y) / (2 * length), (x - beforeX) / (2 * length)];
    context.beginPath();
    context.moveTo(beforeX + sideX * widths[i - 1], beforeY + sideY * widths[i - 1]);
    context.lineTo(x + sideX * widths[i], y + sideY * widths[i]);
    context.lineTo(x - sideX * widths[i], y - sideY * widths[i]);
    context.lineTo(beforeX - sideX * widths[i - 1], beforeY - sideY * widths[i - 1]);
    context.fill();
  }
}
