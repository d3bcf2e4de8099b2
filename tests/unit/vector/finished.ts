/** Runs a generator to its end and returns its result. */
export function finished<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}
