/** Milliseconds of work after which the page gets its turn. */
const SLICE_MS = 8;

/** Divides work on the main thread into slices: after each, the page can draw, show its progress and react to "Cancel". */
export class Slices {
  private end = performance.now() + SLICE_MS;

  /** @param signal aborts the work; left out for work that must not be stopped any more */
  constructor(private readonly signal?: AbortSignal) {}

  /** To be awaited between units of work. Resolves in a later task if the slice is over. Rejects with the signal's reason. */
  async next(): Promise<void> {
    if (performance.now() >= this.end) {
      await laterTask();
      this.end = performance.now() + SLICE_MS;
    }
    this.signal?.throwIfAborted();
  }
}

/** Resolves in a later task. It takes a message, since timers wait longer than asked for, and seconds in a hidden tab. */
const laterTask = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
