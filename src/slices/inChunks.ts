/**
 * How many items (vertices, triangles, half-edges) are worked on between two yields: one to three milliseconds of work,
 * short enough for a slice on the main thread and long enough that the yields cost nothing.
 */
const CHUNK_SIZE = 1 << 14;

/**
 * Calls `body(start, end)` for consecutive ranges that cover [0, count) and yields the finished part in (0, 1] after each.
 *
 * `body` should do no more than call a function of the module with all it needs. Engines keep what they have learnt
 * about such a function from one bake to the next, but start anew with a closure that is made in each bake: measured,
 * a factor of two.
 */
export function* inChunks(count: number, body: (start: number, end: number) => void): Generator<number, void, void> {
  for (let start = 0; start < count; start += CHUNK_SIZE) {
    const end = Math.min(start + CHUNK_SIZE, count);
    body(start, end);
    yield end / count;
  }
}

/** Runs `task` as one phase of a longer one: its progress [0, 1] becomes [from, to]. */
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
