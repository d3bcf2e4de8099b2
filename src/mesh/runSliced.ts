/** Milliseconds per slice: less than a frame. */
const SLICE_MS = 8;

/** Options of `runSliced`. */
export interface SlicedOptions {
  signal?: AbortSignal | undefined;
  onProgress?: ((progress: number) => void) | undefined;
  /** Wraps each slice. It must call `slice` exactly once. */
  around?: ((slice: () => void) => void) | undefined;
}

/**
 * Runs `task` to its end in slices of a few milliseconds. Between slices, events, frames and other tasks get their turn.
 * Progress is reported once per slice and rises strictly. Rejects with the signal's reason when aborted, with the task's
 * own error, or with what `onProgress` throws. The task's `finally` blocks run in every case.
 */
export async function runSliced<Result>(
  task: Generator<number, Result, void>,
  { signal, onProgress, around = (slice) => slice() }: SlicedOptions = {},
): Promise<Result> {
  const pause = createPause();
  let reported = 0;
  try {
    for (;;) {
      signal?.throwIfAborted();
      let step: IteratorResult<number, Result> | undefined;
      around(() => {
        const sliceEnd = performance.now() + SLICE_MS;
        do step = task.next();
        while (!step.done && performance.now() < sliceEnd);
      });
      const { done, value } = step!;
      if (done) return value;
      if (value > reported) {
        reported = value;
        onProgress?.(reported);
      }
      await pause.next();
    }
  } finally {
    pause.close();
    task.return(undefined as never);
  }
}

/**
 * Pauses that let queued events run. In browsers a pause is a message between two ports: nested timers would wait 4 ms each,
 * and a second in a hidden tab. Node has `setImmediate`; it would handle a thousand messages before any other event.
 */
function createPause(): { next(): Promise<void>; close(): void } {
  if (typeof setImmediate === 'function') {
    return { next: () => new Promise((resolve) => setImmediate(resolve)), close: () => {} };
  }
  const { port1, port2 } = new MessageChannel();
  let resume: () => void = () => {};
  port1.onmessage = () => resume();
  return {
    next: () =>
      new Promise((resolve) => {
        resume = resolve;
        port2.postMessage(null);
      }),
    close: () => port1.close(),
  };
}
