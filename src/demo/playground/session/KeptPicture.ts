import { thumbnailWhen } from '../../kept/thumbnailOf.js';
import type { Stage } from '../../stage/Stage.js';
import { whenDrawn } from '../../stage/whenDrawn.js';

/** Takes a thumbnail of a drawing when it has come to rest and is drawn whole. */
export class KeptPicture {
  private isWanted = false;

  constructor(
    private readonly stage: Stage,
    /** Whether nothing is being done that changes the drawing. */
    private readonly isSettled: () => boolean,
    /** Called in the task of a frame, with what is read of it later. */
    private readonly take: (picture: Promise<string>) => void,
  ) {}

  want(): void {
    this.isWanted = true;
    if (this.isAtRest && this.stage.frames.redraw()) this.frameDrawn();
  }

  /** To be called with every frame, in its task. */
  frameDrawn(): void {
    if (!this.isWanted || !this.isAtRest) return;
    this.isWanted = false;
    const { context, canvas } = this.stage;
    this.take(thumbnailWhen(whenDrawn(context), canvas));
  }

  /** If not, another frame follows: a whole one after a sketch, a fine one after a coarse one, and one with what a task brings. */
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
