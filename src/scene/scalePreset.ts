import { scaledSizes } from '../look/measuredFacts.js';
import { scaledOutlineSizes } from '../material/outlines/outlineProperties.js';
import type { HatchingPreset } from './ApplyHatchingOptions.js';

/**
 * Returns a copy of a preset with all widths and distances in CSS pixels multiplied by a factor. Sizes on the object stay the same. For
 * screens it is not needed: materials apply the renderer's pixel ratio themselves.
 *
 * @param factor dpi / 96 for a print that is drawn at a pixel ratio of 1, since a CSS pixel is 1/96 inch. The edges of strokes stay one
 * pixel soft.
 * @throws RangeError if the factor is not a positive number
 */
export function scalePreset(preset: HatchingPreset, factor: number): HatchingPreset {
  if (!(factor > 0 && factor < Infinity)) {
    throw new RangeError(`scalePreset: the factor is ${factor}, but must be a positive number, such as 2.`);
  }
  const { material, outlines } = preset;
  return {
    ...preset,
    material: { ...material, ...scaledSizes(material, factor) },
    outlines: { ...outlines, ...scaledOutlineSizes(outlines, factor) },
  };
}
