import { type MapDrawing, resolveMapDrawing } from '../../strokes/tamImages/hatchImageOptions.js';
import { checkNames } from '../../worker/TaskOptions.js';

/** The names of the options that determine a generated map. */
export const HATCH_IMAGE_OPTIONS = {
  style: true,
  seed: true,
  size: true,
  tones: true,
  levels: true,
  strokeTexels: true,
  hand: true,
} satisfies Record<keyof MapDrawing, true>;

/**
 * Checks the options of a generated map before any work is done.
 *
 * @param caller the function that is named in the error
 * @throws TypeError if the options are not an object or have unknown names; RangeError for values out of their range
 */
export function checkHatchImageOptions(caller: string, options: MapDrawing): void {
  checkNames(caller, 'options', options, HATCH_IMAGE_OPTIONS);
  resolveMapDrawing(options, caller);
}
