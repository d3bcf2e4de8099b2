import { PRESET_MATERIALS } from '../../look/presetMaterials.js';
import type { HatchingLook } from '../../look/queries.js';
import type { ToneCurve } from '../fitToneCurve.js';

/** A cache of whether a tone curve is that of a preset. */
const ofPresets = new WeakMap<object, boolean>();

/** Whether a tone curve is the user's own: points that no preset has. */
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
 * Whether the exposure of a material is fitted to its scene: if it is `'auto'`, except that a user's own tone curve already maps light
 * to tone, and that shadows alone are a share of the light, whatever its strength.
 */
export const isFitted = ({ exposure, toneCurve, toneModel }: HatchingLook): boolean =>
  exposure === 'auto' && toneModel !== 'shadow' && !isByHand(toneCurve as ToneCurve);
