import { type HatchImageOptions, resolveHatchImageOptions } from '../hatchImages/hatchImageOptions.js';
import { checkNames } from '../worker/checkOptions.js';

/** The names of the options of a map that is drawn, beside those of every long task. */
export const HATCH_IMAGE_OPTIONS = {
  style: true,
  seed: true,
  size: true,
  tones: true,
  levels: true,
  strokeWidth: true,
} satisfies Record<keyof HatchImageOptions, true>;

/**
 * Checks what a map is to be drawn with, before any work is done.
 *
 * @param caller named in the error
 * @throws TypeError for what is no object and for unknown names, RangeError for values out of their range
 */
export function checkHatchImageOptions(caller: string, options: HatchImageOptions): void {
  checkNames(caller, 'options', options, HATCH_IMAGE_OPTIONS);
  resolveHatchImageOptions(options);
}
