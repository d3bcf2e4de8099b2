import type { IUniform } from 'three';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { ToneFit } from './ToneFit.js';

/** Writes the exposure of a material from a fit. Allocates nothing. */
export function writeFit(
  fit: ToneFit,
  { exposureCompensation }: HatchingMaterialProperties,
  { exposure, colorExposure }: Readonly<Record<string, IUniform>>,
): void {
  exposure.value.set(fit.scale, fit.offset).multiplyScalar(exposureCompensation);
  colorExposure.value = 1 / fit.white;
}
