import { generateHatchImages, generateThresholds, type MapRequest } from '../internals.js';
import { PhaseClock } from '../PhaseClock.js';

/** Draws a map as often as `repeats` says on the page's main thread, by phase. The first includes the time of compiling. */
export function measureMap(options: MapRequest, repeats: number) {
  const clocks = Array.from({ length: repeats }, () => {
    const clock = new PhaseClock();
    clock.run('images', generateHatchImages(options));
    clock.run('thresholds', generateThresholds(options));
    return clock;
  });
  return { times: clocks.map(({ times }) => times), longestSteps: clocks.map(({ longestStep }) => longestStep) };
}
