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
