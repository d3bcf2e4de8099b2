/** Frames slower than this make a dragged light stutter. */
const SLOW_MILLISECONDS = 55;
/** Frames closer together than this belong to one movement. */
const PAUSE_MILLISECONDS = 350;
const REDUCED_SCALE = 0.5;
const MAX_PIXEL_RATIO = 2;
/** On very large screens the pixel ratio is lowered to stay below this. */
const MAX_PIXELS = 8_000_000;

/** Lowers the resolution while something moves and frames are slow, and restores it when the movement is over. */
export class AdaptiveResolution {
  /** Factor on the full resolution, per side. */
  private scale = 1;
  private isSlow = false;
  private lastFrame = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onRest called when the movement is over, so that a frame in full resolution can be drawn */
  constructor(private readonly onRest: () => void) {}

  get isCoarse(): boolean {
    return this.scale < 1;
  }

  /** Pixels to be drawn per CSS pixel of a viewport, whose size is in CSS pixels. */
  pixelRatio(width: number, height: number): number {
    const full = Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));
    return full * this.scale;
  }

  /** To be called before each frame. Lowers the resolution for it if necessary. */
  beforeFrame(): void {
    const now = performance.now();
    const isMoving = now - this.lastFrame < PAUSE_MILLISECONDS;
    this.lastFrame = now;
    if (!(this.isSlow && isMoving) && !this.isCoarse) return;
    this.scale = REDUCED_SCALE;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.lastFrame = -Infinity;
      this.scale = 1;
      this.onRest();
    }, PAUSE_MILLISECONDS);
  }

  /** To be called with the time that a frame took. */
  measured(milliseconds: number): void {
    if (this.isCoarse) return;
    this.isSlow = milliseconds > SLOW_MILLISECONDS;
    // A slow frame does not end a movement.
    this.lastFrame = Math.max(this.lastFrame, performance.now());
  }
}
