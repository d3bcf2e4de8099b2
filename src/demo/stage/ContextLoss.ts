import type { FrameQuality } from './FrameQuality.js';
import type { Frames } from './Frames.js';
import type { LastPicture } from './LastPicture.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';

/** Lets go of the drawing with its graphics context, and takes it up again; its last picture is on the page in between. */
export class ContextLoss {
  /** Kept from the first loss of the context on: pages that have lost it once are those that lose it again. */
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
    frames.onFrame(() => this.lastPicture?.frameDrawn());
  }

  /** Whether the last picture before the loss of the context is on the page. */
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
    // three.js goes back to black, which saved pictures would have between strokes.
    if (scenery.look) painter.setPaper(scenery.look.paper);
    if (this.lastPicture) this.lastPicture.restored();
    else void this.keepLastPicture();
  }

  private async keepLastPicture(): Promise<void> {
    const { frames } = this;
    // Without it the page goes on as before.
    const part = await import('./LastPicture.js').catch(() => undefined);
    if (!part || this.lastPicture) return;
    this.lastPicture = new part.LastPicture(this.painter.canvas, () => frames.redraw());
    frames.invalidate();
  }
}
