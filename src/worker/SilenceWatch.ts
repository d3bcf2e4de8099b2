/** Milliseconds between two questions. */
const TICK_MS = 1000;

/** Ticks without a sign of life after which the other side counts as gone. */
const SILENT_TICKS = 30;

/** Seconds of silence after which the other side counts as gone. */
export const SILENCE_SECONDS = (SILENT_TICKS * TICK_MS) / 1000;

/**
 * Notices that a worker is gone although no event says so: it was terminated, closed itself or was killed by the system. Asks
 * for a sign of life every second; any message is one.
 *
 * A second counts as silent only if the page is visible and the own timer was punctual. In a hidden page, a sleeping computer
 * or under a busy main thread, the worker or its messages may be held up as well, and the count starts anew.
 */
export class SilenceWatch {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private silentTicks = 0;

  /**
   * @param ask asks for a sign of life
   * @param onSilence called once, when there was none for {@link SILENCE_SECONDS} seconds
   */
  constructor(
    private readonly ask: () => void,
    private readonly onSilence: () => void,
  ) {}

  /** Begins to watch, if it is not watching already. */
  start(): void {
    if (this.timer !== undefined) return;
    this.silentTicks = 0;
    this.wait();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  /** To be called with every sign of life. */
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
    this.ask();
    this.wait();
  }
}
