/** Longest time in milliseconds that a slice may take before other work gets its turn: less than a frame. */
const SLICE_MS = 8;

/** How a computation is watched and stopped while it runs in slices. */
export interface SlicedOptions {
  signal?: AbortSignal | undefined;
  onProgress?: ((progress: number) => void) | undefined;
}

/**
 * Runs `task` to its end in slices of a few milliseconds and lets events, frames and other tasks in between. Progress is
 * reported once per slice and rises strictly. Rejects with the signal's reason when aborted, with the task's own
 * error, or with what `onProgress` throws; the task's `finally` blocks run in every case.
 */
export async function runSliced<Result>(
  task: Generator<number, Result, void>,
  { signal, onProgress }: SlicedOptions = {},
): Promise<Result> {
  const pause = createPause();
  let reported = 0;
  try {
    for (;;) {
      signal?.throwIfAborted();
      const sliceEnd = performance.now() + SLICE_MS;
      let step = task.next();
      while (!step.done && performance.now() < sliceEnd) step = task.next();
      if (step.done) return step.value;
      if (step.value > reported) {
        reported = step.value;
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
 * Pauses that let queued events run. In browsers a message between two ports does that without the delay of timers
 * (4 ms each once nested, a second in a hidden tab). Node handles a thousand messages before anything else, but has
 * `setImmediate`.
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
