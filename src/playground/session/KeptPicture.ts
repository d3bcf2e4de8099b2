import { whenDrawn } from '../viewport/graphicsCard.js';
import type { Viewport } from '../viewport/Viewport.js';

/** Takes a thumbnail once the drawing is complete and nothing moves. */
export class KeptPicture {
  private isWanted = false;

  constructor(
    private readonly viewport: Viewport,
    /** Whether no task is running that will change the drawing. */
    private readonly isSettled: () => boolean,
    /** Receives the thumbnail, whose pixels are read later; called in the task of a frame. */
    private readonly take: (picture: Promise<string>) => void,
  ) {}

  want(): void {
    this.isWanted = true;
    if (this.isAtRest && this.viewport.frames.redraw()) this.frameDrawn();
  }

  /** Call this after each frame, in the same task. */
  frameDrawn(): void {
    if (!this.isWanted || !this.isAtRest) return;
    this.isWanted = false;
    this.take(thumbnailWhen(this.whenStill(), this.viewport.frames.canvas));
  }

  /** Resolves when the graphics card is idle, since reading the copy would wait for later frames too. */
  private async whenStill(): Promise<void> {
    const { context, frames } = this.viewport;
    let count: number;
    do {
      count = frames.count;
      await whenDrawn(context);
    } while (frames.count !== count);
  }

  /** Whether the drawing is final: no further frame will follow a sketch, a coarse frame or a task. */
  private get isAtRest(): boolean {
    const { viewport } = this;
    return (
      viewport.isComplete &&
      !viewport.frames.isWaiting &&
      !viewport.quality.isCoarse &&
      !viewport.shown.isPlaceholder &&
      this.isSettled()
    );
  }
}

/** The size of a thumbnail in pixels. It is shown at half size, so that it is sharp on dense screens. */
const SIDE = 128;

/** A thumbnail of the middle of the drawing, as a data URL. Call this in the task in which the drawing was drawn. */
export const thumbnailOf = (drawing: HTMLCanvasElement): string => addressOf(smallCopyOf(drawing));

/** As {@link thumbnailOf}, but reads pixels only when `drawn` resolves, so that the page does not wait for the graphics card. */
function thumbnailWhen(drawn: Promise<void>, drawing: HTMLCanvasElement): Promise<string> {
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
