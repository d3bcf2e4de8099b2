/** Runs a task that yields its progress to its end. */
export function finished<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}
