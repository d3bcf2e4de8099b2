import { scaledLineSizes } from '../lines/lineProperties.js';
import { scaledSizes } from '../material/facts/lookFacts.js';
import type { HatchingPreset } from './presets.js';

/**
 * Returns a copy of a preset with all widths and distances in pixels multiplied by a factor. Sizes on the object stay the same.
 * The presets are made for one pixel of the drawing buffer per CSS pixel, which is 96 pixels per inch.
 *
 * @param factor `renderer.getPixelRatio()` for a screen, dpi / 96 for a print. The edges of strokes stay one pixel soft.
 * @throws RangeError if the factor is not a positive number
 */
export function scalePreset(preset: HatchingPreset, factor: number): HatchingPreset {
  if (!(factor > 0 && factor < Infinity)) {
    throw new RangeError(`scalePreset: the factor is ${factor}, but must be a positive number, such as 2.`);
  }
  const { material, lines } = preset;
  return {
    ...preset,
    material: { ...material, ...scaledSizes(material, factor) },
    lines: { ...lines, ...scaledLineSizes(lines, factor) },
  };
}
