import type { Hand, HandStroke } from '../strokes/hand/Hand.js';
import type { LearnHandOptions } from '../strokes/hand/learnHand.js';
import { handTaskSet } from './handTaskSet.js';
import { runTaskOf } from './runTask.js';
import { checkOptions, type TaskOptions } from './TaskOptions.js';

/**
 * Options of `learnHandAsync`: those of `learnHand`, and those of the task. A worker of `createWorker` runs `three-hatching/hand.worker`.
 */
export interface LearnHandAsyncOptions extends LearnHandOptions, TaskOptions {}

const LEARN_HAND_OPTIONS = { name: true, maxStrokes: true, maxPoints: true } satisfies Record<
  keyof LearnHandOptions,
  true
>;

/**
 * Does what `learnHand` does, in a worker if possible, so that thousands of strokes do not block the page.
 *
 * @throws TypeError or RangeError (as a rejection) with the fault of the strokes or the options; the signal's reason when aborted
 */
export async function learnHandAsync(
  strokes: readonly HandStroke[],
  options: LearnHandAsyncOptions = {},
): Promise<Hand> {
  checkOptions('learnHandAsync', options, LEARN_HAND_OPTIONS);
  const { name, maxStrokes, maxPoints, ...task } = options;
  const request = () => ({ strokes, options: { name, maxStrokes, maxPoints } });
  return runTaskOf(handTaskSet, 'learnHand', request(), task, request);
}
