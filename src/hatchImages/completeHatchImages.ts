import { deriveThresholds } from './deriveThresholds.js';
import type { ThresholdLevel } from './encodeThresholds.js';
import type { HatchImages } from './HatchImages.js';
import { makeLevels } from './makeLevels.js';

/** Hatch images with what may be missing of a map. */
export interface CompleteHatchImages extends HatchImages {
  thresholds: ThresholdLevel[];
}

/** Makes the levels of images that lack them, and derives the thresholds. Yields progress in [0, 1]. */
export function* completeHatchImages({
  lacksLevels,
  ...given
}: HatchImages & { lacksLevels: boolean }): Generator<number, CompleteHatchImages, void> {
  const { size, images } = lacksLevels ? yield* share(makeLevels(given), 0, 0.5) : given;
  const thresholds = yield* share(deriveThresholds({ size, images }), lacksLevels ? 0.5 : 0, 1);
  return { size, images, thresholds };
}

/** Runs a task whose progress is a part of the whole. */
function* share<Result>(
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
