import { thumbnailWhen } from '../storage/thumbnailOf.js';
import type { Stage } from '../viewport/Stage.js';
import { whenDrawn } from '../viewport/whenDrawn.js';

/** Takes a thumbnail of the drawing when nothing moves any more and the drawing is complete. */
export class KeptPicture {
  private isWanted = false;

  constructor(
    private readonly stage: Stage,
    /** Whether no task is running that will change the drawing. */
    private readonly isSettled: () => boolean,
    /** Called in the task of a frame, with the thumbnail that will be read of it later. */
    private readonly take: (picture: Promise<string>) => void,
  ) {}

  want(): void {
    this.isWanted = true;
    if (this.isAtRest && this.stage.frames.redraw()) this.frameDrawn();
  }

  /** To be called after each frame, in the same task. */
  frameDrawn(): void {
    if (!this.isWanted || !this.isAtRest) return;
    this.isWanted = false;
    this.take(thumbnailWhen(this.whenStill(), this.stage.frames.canvas));
  }

  /** Resolves when the graphics card has nothing to draw: reading the copy waits for later frames too. */
  private async whenStill(): Promise<void> {
    const { context, frames } = this.stage;
    let count: number;
    do {
      count = frames.count;
      await whenDrawn(context);
    } while (frames.count !== count);
  }

  /** Whether the drawing is final. If not, another frame follows: after a sketch, after a coarse frame, or with the result of a task. */
  private get isAtRest(): boolean {
    const { stage } = this;
    return (
      stage.isComplete &&
      !stage.frames.isWaiting &&
      !stage.quality.isCoarse &&
      !stage.shown.isStandIn &&
      this.isSettled()
    );
  }
}
