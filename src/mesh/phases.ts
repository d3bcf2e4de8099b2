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

/** Runs a task to its end at once. */
export function runToEnd<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
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
