const KEPT_DURATIONS = 7;
const POLL_MS = 3;
const GIVE_UP_MS = 10_000;

/**
 * Measures the duration of frames, from the first command to the last pixel, with a fence after the commands. Unlike the time between
 * frames, this works for frames on demand too. It is accurate to a few milliseconds.
 */
export class FrameTimer {
  private durations: number[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private fence: WebGLSync | null = null;

  /** @param onMeasured called when a frame was measured */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly onMeasured: () => void,
  ) {}

  /** The median of the latest frame times in milliseconds, or undefined before the first. */
  get milliseconds(): number | undefined {
    const sorted = [...this.durations].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)];
  }

  /** Discards all measurements. Call it when the scene that is drawn has changed. */
  reset(): void {
    this.durations = [];
    this.stop();
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.gl.deleteSync(this.fence);
    this.fence = null;
  }

  /** Draws a frame and measures it, unless the previous frame is still being measured. */
  measure(draw: () => void): void {
    const start = performance.now();
    draw();
    if (this.timer !== undefined) return;
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!this.fence) return;
    this.gl.flush();
    this.poll(this.fence, start);
  }

  private poll(fence: WebGLSync, start: number): void {
    this.timer = setTimeout(() => {
      const elapsed = performance.now() - start;
      const isDone = this.gl.getSyncParameter(fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
      if (!isDone && elapsed < GIVE_UP_MS && !this.gl.isContextLost()) {
        this.poll(fence, start);
        return;
      }
      this.stop();
      if (this.gl.isContextLost()) return;
      // If the frame is still not finished, the time waited so far counts as its duration.
      this.durations.push(elapsed);
      if (this.durations.length > KEPT_DURATIONS) this.durations.shift();
      this.onMeasured();
    }, POLL_MS);
  }
}
