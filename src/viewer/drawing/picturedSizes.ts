import type { HatchingMaterialParameters } from 'three-hatching';
import { HATCHING_DEFAULTS, scaledSizes } from 'three-hatching/facts';
import type { Look } from '../settings/lookOf.js';

const { finestSpacing } = HATCHING_DEFAULTS;

/**
 * The sizes of materials on a sheet.
 *
 * @param share of the full stroke width, below 1 on small sheets
 * @param scale of a picture relative to the page
 */
export function materialSizesIn(
  { sizes, drawn: { sizedOnScreen } }: Look,
  share: number,
  scale = 1,
): HatchingMaterialParameters {
  return {
    ...sizes,
    ...scaledSizes({ ...sizes, sizedOnScreen }, share * scale),
    // The spacing below which lines merge does not depend on the size of the sheet.
    ...scaledSizes({ finestSpacing }, scale),
  };
}

/** The sizes of outlines. @param factor on all of them */
export function outlineSizesIn({ outlines }: Look, factor: number) {
  return {
    outlineWidth: outlines.outlineWidth * factor,
    wobble: outlines.wobble * factor,
    overshoot: outlines.overshoot * factor,
    toothSize: outlines.toothSize * factor,
  };
}
