import { asPhase } from '../../mesh/phases.js';
import { deriveThresholds } from './deriveThresholds.js';
import type { ThresholdLevel } from './encodeThresholds.js';
import type { HatchImages } from './HatchImages.js';
import { makeLevels } from './makeLevels.js';

/** Hatch images with all levels, and the thresholds. */
export interface CompleteHatchImages extends HatchImages {
  thresholds: ThresholdLevel[];
}

/** Makes the levels of images that lack them, and derives the thresholds. Yields progress in [0, 1]. */
export function* completeHatchImages({
  lacksLevels,
  ...given
}: HatchImages & { lacksLevels: boolean }): Generator<number, CompleteHatchImages, void> {
  const { size, images } = lacksLevels ? yield* asPhase(makeLevels(given), 0, 0.5) : given;
  const thresholds = yield* asPhase(deriveThresholds({ size, images }), lacksLevels ? 0.5 : 0, 1);
  return { size, images, thresholds };
}
