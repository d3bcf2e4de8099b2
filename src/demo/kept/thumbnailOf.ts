/** Side of a thumbnail in its own pixels: sharp on dense screens, where it is shown half as large. */
const SIDE = 128;

/** The middle of the drawing, square and small, as the address of an image. To be called in the task in which the drawing was drawn. */
export function thumbnailOf(drawing: HTMLCanvasElement): string {
  const side = Math.min(drawing.width, drawing.height);
  const canvas = Object.assign(document.createElement('canvas'), { width: SIDE, height: SIDE });
  const context = canvas.getContext('2d');
  if (context) {
    context.imageSmoothingQuality = 'high';
    const [left, top] = [(drawing.width - side) / 2, (drawing.height - side) / 2];
    context.drawImage(drawing, left, top, side, side, 0, 0, SIDE, SIDE);
  }
  return canvas.toDataURL('image/webp', 0.8);
}
