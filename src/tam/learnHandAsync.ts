import type { Hand, HandStroke } from '../hand/Hand.js';
import { type LearnHandOptions, learnHandSteps } from '../hand/learnHand.js';
import { runSliced } from '../slices/runSliced.js';
import { checkOptions } from '../worker/checkOptions.js';
import type { TaskOptions } from '../worker/TaskOptions.js';

/** Options of `learnHandAsync`: those of `learnHand`, and how it is followed and stopped. */
export interface LearnHandAsyncOptions extends LearnHandOptions, Pick<TaskOptions, 'signal' | 'onProgress'> {}

const LEARN_HAND_OPTIONS = { name: true, maxStrokes: true, maxPoints: true } satisfies Record<
  keyof LearnHandOptions,
  true
>;

/**
 * Does what `learnHand` does, in slices of a few milliseconds: for thousands of strokes, which would hold up the page otherwise.
 *
 * @throws TypeError or RangeError (as a rejection) that says in a sentence what is wrong with the strokes or the options; the signal's
 *   reason when aborted
 */
export async function learnHandAsync(
  strokes: readonly HandStroke[],
  options: LearnHandAsyncOptions = {},
): Promise<Hand> {
  checkOptions('learnHandAsync', options, LEARN_HAND_OPTIONS);
  const { signal, onProgress, ...learning } = options;
  return runSliced(learnHandSteps({ strokes, options: learning }), {
    signal: signal ?? undefined,
    onProgress: onProgress ?? undefined,
  });
}
