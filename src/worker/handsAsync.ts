import type { Hand, HandStroke } from '../strokes/hand/Hand.js';
import type { LearnHandOptions } from '../strokes/hand/learnHand.js';
import { checkScannedImage, type ScannedImage } from '../strokes/strokeTracing/ScannedImage.js';
import type { TraceOptions } from '../strokes/strokeTracing/traceStrokesSteps.js';
import type { handTasks } from './handTasks.js';
import { runTaskOf } from './runTask.js';
import { checkOptions, type TaskOptions } from './TaskOptions.js';
import type { TaskSet } from './TaskSet.js';

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

/**
 * Options of `traceStrokes`: facts about the picture, and those of the task. A worker of `createWorker` runs `three-hatching/hand.worker`.
 */
export interface TraceStrokesOptions extends TraceOptions, TaskOptions {}

const OPTIONS = { millimetresPerPixel: true, swatch: true } satisfies Record<keyof TraceOptions, true>;

/**
 * Finds the strokes in a photograph or a scan of a swatch, in a worker if possible: separates ink from paper in uneven light, thins it to lines,
 * lets lines that cross go straight on, and measures the width along each. `learnHand` makes a hand of them.
 *
 * Strokes should be three pixels wide or more, and apart from each other by as much; those that touch side by side become one. A stroke's
 * ends are where a round pen would have stood. Ink does not tell which way it was drawn: most strokes go to the right.
 *
 * ```ts
 * const bitmap = await createImageBitmap(file);
 * const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
 * context.drawImage(bitmap, 0, 0);
 * const strokes = await traceStrokes(context.getImageData(0, 0, bitmap.width, bitmap.height), { swatch: 'middle' });
 * const hand = learnHand(strokes);
 * ```
 *
 * @param image the picture, such as an `ImageData`, with at most 16 million pixels; it is copied
 * @throws TypeError or RangeError (as a rejection) if the picture or an option is out of its range; Error if there are no strokes in it, or
 *   more than 1000; the signal's reason when aborted
 */
export async function traceStrokes(image: ScannedImage, options: TraceStrokesOptions = {}): Promise<HandStroke[]> {
  checkOptions('traceStrokes', options, OPTIONS);
  const { millimetresPerPixel, swatch, ...task } = options;
  checkScannedImage(image);
  const request = () => {
    const { width, height, data } = image;
    return { image: { width, height, data: data.slice() }, millimetresPerPixel, swatch };
  };
  return runTaskOf(handTaskSet, 'traceStrokes', request(), task, request);
}

/** The tasks for hands, for `runTaskOf`. */
const handTaskSet: TaskSet<typeof handTasks> = {
  fetchTasks: async () => (await import('./handTasks.js')).handTasks,
  requestBuffers: {
    learnHand: () => [],
    traceStrokes: ({ image }) => [image.data.buffer as ArrayBuffer],
  },
  fetchWorker: async () => (await import('./inlineHandWorker.js')).createInlineHandWorker,
};
