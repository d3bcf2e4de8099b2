import { type Color, type ColorRepresentation, Vector2 } from 'three';
import type { HatchingMaterialParameters, HatchingPropertyName } from 'three-hatching';
import { HATCHING_PROPERTIES } from 'three-hatching/facts';
import type { EitherMaterial } from './NodeMakers.js';

/**
 * Sets parameters of materials, one material after the other. `setValues` would warn of what the technique does not use, which the
 * page keeps for the next technique.
 *
 * @returns what sets them on a material: parameters are sorted by kind once for all materials
 */
export function parameterSetter(parameters: HatchingMaterialParameters): (material: EitherMaterial) => void {
  const entries = Object.entries(parameters) as [HatchingPropertyName, unknown][];
  const colors = entries.filter(([name]) => HATCHING_PROPERTIES[name].kind === 'color');
  const vectors = entries.filter(([, value]) => value instanceof Vector2);
  const others = Object.fromEntries(entries.filter((entry) => !colors.includes(entry) && !vectors.includes(entry)));
  return (material) => {
    Object.assign(material, others);
    for (const [name, value] of vectors) (material[name] as Vector2).copy(value as Vector2);
    for (const [name, value] of colors) (material[name] as Color).set(value as ColorRepresentation);
  };
}
