/** Milliseconds of work before the main thread is yielded. */
const SLICE_MS = 8;

/** Splits work on the main thread into time slices, between which the page can draw, show progress and react to "Cancel". */
export class Slices {
  private end = performance.now() + SLICE_MS;

  /** @param signal aborts the work; left out for work that must not be aborted */
  constructor(private readonly signal?: AbortSignal) {}

  /** Await this between units of work. If the slice is over, it resolves in a later task. Rejects with the signal's reason. */
  async next(): Promise<void> {
    if (performance.now() >= this.end) {
      await laterTask();
      this.end = performance.now() + SLICE_MS;
    }
    this.signal?.throwIfAborted();
  }
}

/** Resolves in a later task. Uses a message, since timers wait longer than asked for, and seconds in a hidden tab. */
const laterTask = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
