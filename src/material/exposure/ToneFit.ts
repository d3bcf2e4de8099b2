import type { IUniform } from 'three';
import { PRESET_MATERIALS } from '../../look/presetMaterials.js';
import type { HatchingLook } from '../../look/queries.js';
import type { ToneCurve } from '../fitToneCurve.js';

/** The parameters that turn the light and the colours of a scene into tone. */
export interface ToneFit {
  /** The factor on the radiance of a white surface. */
  scale: number;
  /** The offset that is added after it. */
  offset: number;
  /** The lightness of colours that are left blank, from 0, black, to 1, white (CIE lightness). Lighter colours are left blank too. */
  white: number;
}

/** Writes the exposure of a material from a fit. Allocates nothing. */
export function writeFit(
  fit: ToneFit,
  { composition: { exposureCompensation } }: { readonly composition: { readonly exposureCompensation: number } },
  { exposure, colorExposure }: Readonly<Record<string, IUniform>>,
): void {
  exposure.value.set(fit.scale, fit.offset).multiplyScalar(exposureCompensation);
  colorExposure.value = 1 / fit.white;
}

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
 * Whether the exposure of a material is fitted to its scene: if it is `'fit'` or `'auto'`, except that a user's own tone curve already maps light
 * to tone, and that shadows alone are a share of the light, whatever its strength.
 */
export const isFitted = ({ composition, toneCurve, isHatchingShadowMaterial }: HatchingLook): boolean =>
  typeof composition?.exposure === 'string' && isHatchingShadowMaterial !== true && !isByHand(toneCurve as ToneCurve);
