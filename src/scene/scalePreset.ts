import { scaledLineSizes } from '../lines/lineProperties.js';
import { scaledSizes } from '../material/lookFacts.js';
import type { HatchingPreset } from './presets.js';

/**
 * A preset with all its widths and distances in pixels multiplied; those on the object stay as they are. Those of a preset are
 * for one pixel of the drawing buffer per CSS pixel, 96 to the inch.
 *
 * @param factor for a screen `renderer.getPixelRatio()`; for a print its dpi / 96. The edges of strokes stay a pixel soft.
 * @throws RangeError if it is not a positive number
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
