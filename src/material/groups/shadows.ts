import { PRESET_SHADOWS } from '../../look/presetMaterials.js';
import { defaultOf, spelledOut } from '../../look/presetParameters.js';
import { techniqueOf } from '../../look/queries.js';
import { namesOfOwner } from '../checkProperty.js';
import type { HatchingMaterialParameters } from '../checkValues.js';
import { accessorOf } from '../propertyAccessors.js';
import type { HatchingShadowOptions } from './ownedProperties.js';

/** What the materials of grounds that show shadows alone have in common, for GLSL and nodes. */

/** The parameters of `new HatchingShadowMaterial()` and its `setValues()`. */
export type HatchingShadowMaterialParameters = HatchingMaterialParameters & Partial<HatchingShadowOptions>;

/** The parameters with what their preset says of shadows. */
export function withPresetShadow<Parameters extends HatchingShadowMaterialParameters>(
  values: Parameters,
): HatchingShadowMaterialParameters {
  const { preset } = values;
  if (preset === undefined) return values;
  const technique = techniqueOf(spelledOut(values));
  const shadowSoftness = PRESET_SHADOWS[preset]?.shadowSoftness ?? defaultOf('shadowSoftness', technique);
  return { shadowSoftness: shadowSoftness as number, ...values };
}

/** What a ground that shows shadows alone starts with. */
export const CLEAR = { transparent: true, paperOpacity: 0 } as const;

/** Defines the properties of shadows on the prototype of a material, unless it has them. */
export function defineShadows(material: object): void {
  for (const name of namesOfOwner('shadowMaterial'))
    if (!(name in material)) Object.defineProperty(Object.getPrototypeOf(material), name, accessorOf(name));
}
