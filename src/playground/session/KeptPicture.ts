import { thumbnailWhen } from '../storage/thumbnailOf.js';
import type { Viewport } from '../viewport/Viewport.js';
import { whenDrawn } from '../viewport/whenDrawn.js';

/** Takes a thumbnail of the drawing when nothing moves any more and the drawing is complete. */
export class KeptPicture {
  private isWanted = false;

  constructor(
    private readonly viewport: Viewport,
    /** Whether no task is running that will change the drawing. */
    private readonly isSettled: () => boolean,
    /** Called in the task of a frame, with the thumbnail that will be read of it later. */
    private readonly take: (picture: Promise<string>) => void,
  ) {}

  want(): void {
    this.isWanted = true;
    if (this.isAtRest && this.viewport.frames.redraw()) this.frameDrawn();
  }

  /** To be called after each frame, in the same task. */
  frameDrawn(): void {
    if (!this.isWanted || !this.isAtRest) return;
    this.isWanted = false;
    this.take(thumbnailWhen(this.whenStill(), this.viewport.frames.canvas));
  }

  /** Resolves when the graphics card has nothing to draw: reading the copy waits for later frames too. */
  private async whenStill(): Promise<void> {
    const { context, frames } = this.viewport;
    let count: number;
    do {
      count = frames.count;
      await whenDrawn(context);
    } while (frames.count !== count);
  }

  /** Whether the drawing is final. If not, another frame follows: after a sketch, after a coarse frame, or with the result of a task. */
  private get isAtRest(): boolean {
    const { viewport } = this;
    return (
      viewport.isComplete &&
      !viewport.frames.isWaiting &&
      !viewport.quality.isCoarse &&
      !viewport.shown.isStandIn &&
      this.isSettled()
    );
  }
}
