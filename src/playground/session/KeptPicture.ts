import { thumbnailWhen } from '../storage/thumbnailOf.js';
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
