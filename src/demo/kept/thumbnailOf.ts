/** Side of a thumbnail in its own pixels: sharp on dense screens, where it is shown half as large. */
const SIDE = 128;

/** The middle of the drawing, square and small, as the address of an image. To be called in the task in which the drawing was drawn. */
export const thumbnailOf = (drawing: HTMLCanvasElement): string => addressOf(smallCopyOf(drawing));

/** The same, read when `drawn` resolves: the page does not stand still until the graphics card has drawn the drawing. */
export function thumbnailWhen(drawn: Promise<void>, drawing: HTMLCanvasElement): Promise<string> {
  const copy = smallCopyOf(drawing);
  return drawn.then(() => addressOf(copy));
}

const addressOf = (canvas: HTMLCanvasElement): string => canvas.toDataURL('image/webp', 0.8);

function smallCopyOf(drawing: HTMLCanvasElement): HTMLCanvasElement {
  const side = Math.min(drawing.width, drawing.height);
  const canvas = Object.assign(document.createElement('canvas'), { width: SIDE, height: SIDE });
  const context = canvas.getContext('2d');
  if (context) {
    context.imageSmoothingQuality = 'high';
    const [left, top] = [(drawing.width - side) / 2, (drawing.height - side) / 2];
    context.drawImage(drawing, left, top, side, side, 0, 0, SIDE, SIDE);
  }
  return canvas;
}
