const KEPT_DURATIONS = 7;
const POLL_MILLISECONDS = 3;
const GIVE_UP_MILLISECONDS = 10_000;

/**
 * Measures how long frames take, from the first command to the last pixel, by a fence behind the commands. Unlike the
 * distance between frames that says something also when frames are drawn one at a time. Good to a few milliseconds.
 */
export class FrameTimer {
  private durations: number[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onMeasured called when the time of a frame has become known */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly onMeasured: () => void,
  ) {}

  /** The middle one of the latest frame times in milliseconds, or undefined before there is any. */
  get milliseconds(): number | undefined {
    const sorted = [...this.durations].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)];
  }

  /** Forgets what was measured, because what is drawn has changed. */
  reset(): void {
    this.durations = [];
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  /** Draws, and measures it unless the frame before is still under way. */
  measure(draw: () => void): void {
    const start = performance.now();
    draw();
    if (this.timer !== undefined) return;
    const fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    this.gl.flush();
    this.poll(fence, start);
  }

  private poll(fence: WebGLSync, start: number): void {
    this.timer = setTimeout(() => {
      const elapsed = performance.now() - start;
      const isDone = this.gl.getSyncParameter(fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
      if (!isDone && elapsed < GIVE_UP_MILLISECONDS && !this.gl.isContextLost()) {
        this.poll(fence, start);
        return;
      }
      this.timer = undefined;
      this.gl.deleteSync(fence);
      if (!isDone) return;
      this.durations.push(elapsed);
      if (this.durations.length > KEPT_DURATIONS) this.durations.shift();
      this.onMeasured();
    }, POLL_MILLISECONDS);
  }
}
