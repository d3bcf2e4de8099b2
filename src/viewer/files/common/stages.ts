/** Reports the current step in a few words, and its number of bytes if they exceed those of the files. */
export type OnStage = (stage: string, bytes?: number) => void;

/** The interval between reports of one step, in milliseconds. */
const INTERVAL_MS = 500;

/** Reports a step, and returns a function that reports how far it is, for progress in [0, 1]. */
export function reportStage(stage: string, onStage: OnStage): (progress: number) => void {
  onStage(stage);
  let said = performance.now();
  return (progress) => {
    if (performance.now() < said + INTERVAL_MS) return;
    said = performance.now();
    onStage(`${stage}: ${Math.floor(100 * progress)} %`);
  };
}

/** Runs a task that yields its progress in [0, 1] to its end at once, and reports it as a step. */
export function runStage<Result>(stage: string, onStage: OnStage, task: Generator<number, Result, void>): Result {
  const onProgress = reportStage(stage, onStage);
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
    onProgress(step.value);
  }
}
