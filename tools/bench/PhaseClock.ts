/** Runs the tasks of a longer work to their ends, and adds up what each phase takes. */
export class PhaseClock {
  /** Milliseconds by phase. */
  readonly times: Record<string, number> = {};
  /** Longest time between two yields, in milliseconds: what a slice on the main thread may overrun by. */
  longestStep = 0;

  readonly run = <Result>(phase: string, task: Generator<number, Result, void>): Result => {
    const start = performance.now();
    for (let last = start; ; ) {
      const step = task.next();
      const now = performance.now();
      this.longestStep = Math.max(this.longestStep, now - last);
      last = now;
      if (!step.done) continue;
      this.times[phase] = (this.times[phase] ?? 0) + now - start;
      return step.value;
    }
  };
}
