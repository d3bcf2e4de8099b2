/** The size of a thumbnail in pixels. It is shown at half size, so that it is sharp on dense screens. */
const SIDE = 128;

/** A thumbnail of the middle of the drawing, as a data URL. Call this in the task in which the drawing was drawn. */
export const thumbnailOf = (drawing: HTMLCanvasElement): string => addressOf(smallCopyOf(drawing));

/** As {@link thumbnailOf}, but reads pixels only when `drawn` resolves, so that the page does not wait for the graphics card. */
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
