import type { FrameQuality } from './FrameQuality.js';
import type { Frames } from './Frames.js';
import type { LastPicture } from './LastPicture.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';

/** Frees the resources of a lost graphics context, and shows the last picture until the context is restored. */
export class ContextLoss {
  /** Pictures are copied from the first loss on: a page that has lost its context once is likely to lose it again. */
  private lastPicture: LastPicture | undefined;

  constructor(
    private readonly painter: Painter,
    private readonly scenery: Scenery,
    private readonly frames: Frames,
    private readonly quality: FrameQuality,
  ) {
    const { canvas } = painter;
    canvas.addEventListener('webglcontextlost', () => this.lose());
    canvas.addEventListener('webglcontextrestored', () => this.restore());
    frames.onFrame(() => {
      if (!frames.screen) this.lastPicture?.frameDrawn();
    });
  }

  /** Whether the page shows the last picture from before the context was lost. */
  get showsLastPicture(): boolean {
    return this.painter.isLost && this.lastPicture?.isKept === true;
  }

  private lose(): void {
    const { painter, quality } = this;
    quality.finishSketch();
    quality.restart(false);
    painter.stopBuilding();
    painter.forgetPrograms();
    this.scenery.releaseGraphics();
    this.lastPicture?.lost();
  }

  private restore(): void {
    const { painter, scenery } = this;
    painter.outdateShadows();
    // three.js resets the clear colour to black, which saved pictures would show between strokes.
    if (scenery.look) painter.setPaper(scenery.look.paper);
    if (this.lastPicture) this.lastPicture.restored();
    else void this.keepLastPicture();
  }

  private async keepLastPicture(): Promise<void> {
    const { frames } = this;
    // If this part cannot be fetched, the page works without a last picture.
    const part = await import('./LastPicture.js').catch(() => undefined);
    if (!part || this.lastPicture) return;
    this.lastPicture = new part.LastPicture(this.painter.canvas, () => !frames.screen && frames.redraw());
    frames.invalidate();
  }
}

/** The graphics context was lost. The caller that was saving the drawing explains what that means. */
export class LostContextError extends Error {}
