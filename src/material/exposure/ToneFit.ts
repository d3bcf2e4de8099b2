import type { IUniform } from 'three';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';

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
  { exposureCompensation }: HatchingMaterialProperties,
  { exposure, colorExposure }: Readonly<Record<string, IUniform>>,
): void {
  exposure.value.set(fit.scale, fit.offset).multiplyScalar(exposureCompensation);
  colorExposure.value = 1 / fit.white;
}
