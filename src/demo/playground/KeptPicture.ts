import type { HatchingScene } from '../stage/createScene.js';
import { thumbnailOf } from './thumbnailOf.js';

/** Takes a thumbnail of a drawing when it has come to rest, in a frame that is drawn whole. */
export class KeptPicture {
  private isWanted = false;

  constructor(
    private readonly scene: HatchingScene,
    /** Whether nothing is being done that changes the drawing. */
    private readonly isSettled: () => boolean,
    private readonly take: (picture: string) => void,
  ) {}

  want(): void {
    this.isWanted = true;
    this.scene.invalidate();
  }

  /** To be called with every frame, in its task. */
  frameDrawn(): void {
    const { scene } = this;
    // A sketch is followed by a whole frame, a coarse frame by a fine one, and a task by a frame with what it brings.
    if (!this.isWanted || scene.isWaiting || scene.isCoarse || scene.isStandIn || !this.isSettled()) return;
    this.isWanted = false;
    this.take(thumbnailOf(scene.canvas));
  }
}
