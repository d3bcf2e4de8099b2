import { LINE_SIZES, STROKE_SIZES } from './pixelSizes.js';
import type { HatchingPreset } from './presets.js';

/**
 * A preset with all its widths and distances multiplied. Those of a preset are for one pixel of the drawing buffer per CSS
 * pixel, 96 to the inch.
 *
 * @param factor for a screen `renderer.getPixelRatio()`; for a print its dpi / 96. The edges of strokes stay a pixel soft.
 * @throws RangeError if it is not a positive number
 */
export function scalePreset(preset: HatchingPreset, factor: number): HatchingPreset {
  if (!(factor > 0 && factor < Infinity)) {
    throw new RangeError(`scalePreset: the factor is ${factor}, but must be a positive number, such as 2.`);
  }
  return {
    ...preset,
    material: scaled(preset.material, STROKE_SIZES, factor),
    lines: scaled(preset.lines, LINE_SIZES, factor),
  };
}

function scaled<Name extends string, Values extends { readonly [Key in Name]?: number | null | undefined }>(
  values: Values,
  names: readonly Name[],
  factor: number,
): Values {
  const given = names.filter((name) => typeof values[name] === 'number');
  return { ...values, ...Object.fromEntries(given.map((name) => [name, Number(values[name]) * factor])) };
}
