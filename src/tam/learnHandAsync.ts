import type { Hand, HandStroke } from '../hand/Hand.js';
import type { LearnHandOptions } from '../hand/learnHand.js';
import { checkOptions } from '../worker/checkOptions.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';

/** Options of `learnHandAsync`: those of `learnHand`, and those of the task. */
export interface LearnHandAsyncOptions extends LearnHandOptions, TaskOptions {}

const LEARN_HAND_OPTIONS = { name: true, maxStrokes: true, maxPoints: true } satisfies Record<
  keyof LearnHandOptions,
  true
>;

/**
 * Does what `learnHand` does, in a worker if possible: for thousands of strokes, which take longer than a frame.
 *
 * @throws TypeError or RangeError (as a rejection) that says in a sentence what is wrong with the strokes or the options; the signal's
 *   reason when aborted
 */
export async function learnHandAsync(
  strokes: readonly HandStroke[],
  options: LearnHandAsyncOptions = {},
): Promise<Hand> {
  checkOptions('learnHandAsync', options, LEARN_HAND_OPTIONS);
  const { name, maxStrokes, maxPoints, ...taskOptions } = options;
  const request = { strokes, options: { name, maxStrokes, maxPoints } };
  return runTask('learnHand', request, taskOptions, () => request);
}
