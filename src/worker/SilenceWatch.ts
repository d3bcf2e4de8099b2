/** Milliseconds between two pings. */
const TICK_MS = 1000;

/** The number of ticks without a message after which the worker counts as gone. */
const SILENT_TICKS = 30;

/** Seconds without a message after which the worker counts as gone. */
export const SILENCE_SECONDS = (SILENT_TICKS * TICK_MS) / 1000;

/**
 * Notices that a worker is gone when no event reports it: because it was terminated, closed itself or was killed by the
 * system. The watch pings the worker every second; any message from it is a sign of life.
 *
 * A second counts as silent only if the page is visible and the watch's own timer was punctual. If the page is hidden, the
 * computer asleep or the main thread busy, the worker or its messages may be delayed too, so the count starts again.
 */
export class SilenceWatch {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private silentTicks = 0;

  /**
   * @param ping asks the worker for a sign of life
   * @param onSilence called once, after {@link SILENCE_SECONDS} seconds without any
   */
  constructor(
    private readonly ping: () => void,
    private readonly onSilence: () => void,
  ) {}

  /** Starts to watch, unless it already does. */
  start(): void {
    if (this.timer !== undefined) return;
    this.silentTicks = 0;
    this.wait();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  /** Must be called with every message of the worker. */
  hear(): void {
    this.silentTicks = 0;
  }

  private wait(): void {
    const due = performance.now() + TICK_MS;
    this.timer = setTimeout(() => this.tick(performance.now() - due), TICK_MS);
  }

  private tick(lateness: number): void {
    const isVisible = typeof document === 'undefined' || document.visibilityState === 'visible';
    this.silentTicks = isVisible && lateness < TICK_MS ? this.silentTicks + 1 : 0;
    if (this.silentTicks >= SILENT_TICKS) {
      this.stop();
      this.onSilence();
      return;
    }
    this.ping();
    this.wait();
  }
}
