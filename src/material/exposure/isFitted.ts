import { PRESET_MATERIALS } from '../../look/presetMaterials.js';
import type { HatchingLook } from '../../look/queries.js';
import type { ToneCurve } from '../fitToneCurve.js';

/** Curves that were asked about, and whether they are of a preset. */
const ofPresets = new WeakMap<object, boolean>();

/** Whether a tone curve was drawn by hand: points that no preset has. */
function isByHand(curve: ToneCurve): boolean {
  if (typeof curve === 'string') return false;
  let isOfPreset = ofPresets.get(curve);
  if (isOfPreset === undefined) {
    const points = JSON.stringify(curve);
    isOfPreset = Object.values(PRESET_MATERIALS).some(({ toneCurve }) => JSON.stringify(toneCurve) === points);
    ofPresets.set(curve, isOfPreset);
  }
  return !isOfPreset;
}

/**
 * Whether the exposure of a material is fitted to its scene: where it is `'auto'`. A tone curve that was given by hand says itself which
 * light makes which tone, and shadows alone are a share of the light, whatever it is.
 */
export const isFitted = ({ exposure, toneCurve, toneModel }: HatchingLook): boolean =>
  exposure === 'auto' && toneModel !== 'shadow' && !isByHand(toneCurve as ToneCurve);
