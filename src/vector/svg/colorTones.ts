import { Vector4 } from 'three';
import { isFitted, LUMINANCE, type ToneFit, writeFilter } from '../../material/exposure/ToneFit.js';
import { writeValues } from '../../material/exposure/writeFit.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { ColorTones } from '../shading/tone.js';

/** Colours that are no tones. */
const NONE: ColorTones = {
  colorHatching: 0,
  colorExposure: 1,
  colorFilter: [...LUMINANCE, 0],
  valueKnots: [],
  valueBends: [],
};

/**
 * How the colours of a material become tones.
 *
 * @param material null for one that is not hatched
 * @param fit of the exposure to the scene
 */
export function colorTonesOf(material: HatchingMaterial | null, fit: ToneFit): ColorTones {
  if (!material) return NONE;
  const { colorHatching, composition } = material;
  if (!isFitted(material)) return { ...NONE, colorHatching };
  const { white, plan } = composition.kept(fit);
  const [colorFilter, knots, bends] = [new Vector4(), new Vector4(), new Vector4()];
  writeValues(plan, material, knots, bends);
  writeFilter(plan.filter, composition.plannedValues, colorFilter);
  return {
    colorHatching,
    colorExposure: 1 / white,
    colorFilter: colorFilter.toArray(),
    valueKnots: knots.toArray(),
    valueBends: bends.toArray(),
  };
}
