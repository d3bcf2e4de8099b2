/** Slower than this and a light that is dragged would stutter. */
const SLOW_MILLISECONDS = 55;
/** Frames closer together than this belong to one movement. */
const PAUSE_MILLISECONDS = 350;
const REDUCED_SCALE = 0.5;

/** Lowers the resolution while something moves on a machine too slow for it, and draws once more in full afterwards. */
export class AdaptiveResolution {
  /** Share of the full resolution, per side. */
  scale = 1;
  private isSlow = false;
  private lastFrame = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onRest called when the movement is over and the drawing should be drawn in full */
  constructor(private readonly onRest: () => void) {}

  get isCoarse(): boolean {
    return this.scale < 1;
  }

  /** To be told before each frame; sets {@link scale} for it. */
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

  /** To be told how long a frame in full resolution takes. */
  measured(milliseconds: number): void {
    if (this.isCoarse) return;
    this.isSlow = milliseconds > SLOW_MILLISECONDS;
    // The frame took its time; a movement is not over because of that.
    this.lastFrame = Math.max(this.lastFrame, performance.now());
  }
}
