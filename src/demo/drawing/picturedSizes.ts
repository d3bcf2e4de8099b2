import { HATCHING_DEFAULTS, type HatchingMaterialParameters, scaledSizes } from 'three-hatching';
import type { Look } from '../settings/lookOf.js';

const { finestSpacing } = HATCHING_DEFAULTS;

/**
 * The sizes of materials in a picture: those that are measured in pixels go with it.
 *
 * @param pixelRatio pixels of the picture per CSS pixel
 * @param share of the resolution that the picture is shown in, where it is drawn in a lower one for a moment
 */
export function materialSizesIn(
  { sizes, drawn: { screenConstancy } }: Look,
  pixelRatio: number,
  share = 1,
): HatchingMaterialParameters {
  return {
    ...sizes,
    ...scaledSizes({ ...sizes, screenConstancy }, pixelRatio),
    ...scaledSizes({ finestSpacing }, share),
  };
}

/** The sizes of lines in a picture, all of which are measured in its pixels. @param pixelRatio as above */
export function lineSizesIn({ lines }: Look, pixelRatio: number) {
  return {
    lineWidth: lines.lineWidth * pixelRatio,
    wobble: lines.wobble * pixelRatio,
    overshoot: lines.overshoot * pixelRatio,
    toothSize: lines.toothSize * pixelRatio,
  };
}
