/** Frames further apart than this were not drawn in a row, so their distance says nothing about speed. */
const SAME_RUN_MILLISECONDS = 1000;
const KEPT = 12;

/** Draws when asked to, at most once per screen refresh, and measures how long frames take when they follow each other. */
export class FrameClock {
  /** Frames drawn since the start. */
  frames = 0;
  private request = 0;
  private lastFrame = -Infinity;
  private readonly durations: number[] = [];

  constructor(private readonly draw: () => void) {}

  /** Asks for one frame; asking again before it is drawn changes nothing. */
  invalidate(): void {
    this.request ||= requestAnimationFrame(this.onFrame);
  }

  /** The middle one of the latest frame times in milliseconds, or undefined before two frames were drawn in a row. */
  get frameMilliseconds(): number | undefined {
    const sorted = [...this.durations].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)];
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
  }

  private readonly onFrame = (now: number): void => {
    this.request = 0;
    this.frames++;
    const duration = now - this.lastFrame;
    this.lastFrame = now;
    if (duration < SAME_RUN_MILLISECONDS) {
      this.durations.push(duration);
      if (this.durations.length > KEPT) this.durations.shift();
    } else this.durations.length = 0;
    this.draw();
  };
}
