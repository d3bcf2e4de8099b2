import { HATCHING_DEFAULTS, type HatchingMaterialParameters, scaledSizes } from 'three-hatching';
import type { Look } from '../settings/lookOf.js';

const { finestSpacing } = HATCHING_DEFAULTS;

/**
 * The sizes of materials on a sheet.
 *
 * @param share of their width that strokes have on a small sheet
 * @param scale of a picture whose size is not that of the page
 */
export function materialSizesIn(
  { sizes, drawn: { screenConstancy } }: Look,
  share: number,
  scale = 1,
): HatchingMaterialParameters {
  return {
    ...sizes,
    ...scaledSizes({ ...sizes, screenConstancy }, share * scale),
    // Where lines become too close to be told apart, the sheet does not matter.
    ...scaledSizes({ finestSpacing }, scale),
  };
}

/** The sizes of lines. @param factor on all of them */
export function lineSizesIn({ lines }: Look, factor: number) {
  return {
    lineWidth: lines.lineWidth * factor,
    wobble: lines.wobble * factor,
    overshoot: lines.overshoot * factor,
    toothSize: lines.toothSize * factor,
  };
}
