/**
 * Helpers of the generators that do long computations: each yields its progress in [0, 1] every few milliseconds.
 */

/** Runs `task` as one phase of a longer task: its progress in [0, 1] becomes progress in [from, to]. */
export function* asPhase<Result>(
  task: Generator<number, Result, void>,
  from: number,
  to: number,
): Generator<number, Result, void> {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
    yield from + (to - from) * step.value;
  }
}

/**
 * Items (vertices, triangles, half-edges) per chunk. A chunk takes one to three milliseconds: short enough for a slice on
 * the main thread, long enough that the yields cost nothing.
 */
const CHUNK_SIZE = 1 << 14;

/**
 * Calls `body(start, end)` for consecutive ranges that cover [0, count). Yields the finished part in (0, 1] after each.
 *
 * `body` should only pass its variables to a module-level function. Engines keep the optimised code of such a function from one bake to the
 * next; a closure, made anew in each bake, was measured to be half as fast.
 */
export const forEachChunk = (count: number, body: ChunkBody): Generator<number, void, void> =>
  chunkPhase(count, 0, 1, body);

type ChunkBody = (start: number, end: number) => void;

/** The same as one phase of a longer task: its progress rises from `from` to `to`. */
export function* chunkPhase(count: number, from: number, to: number, body: ChunkBody): Generator<number, void, void> {
  for (let start = 0; start < count; start += CHUNK_SIZE) {
    const end = Math.min(start + CHUNK_SIZE, count);
    body(start, end);
    yield from + (to - from) * (end / count);
  }
}

/** `ArrayBuffer.prototype.transfer` is missing in TypeScript's library for this target. */
type Releasable = ArrayBufferLike & { transfer?(length: number): ArrayBuffer };

/**
 * Frees the memory of arrays at once and leaves them empty. Garbage collection comes late for memory outside the heap: without this, a bake
 * holds twice what it uses. Does nothing in engines without `ArrayBuffer.prototype.transfer`.
 */
export function release(...arrays: ArrayBufferView[]): void {
  for (const { buffer } of arrays as { buffer: Releasable }[]) if (buffer.byteLength > 0) buffer.transfer?.(0);
}

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
