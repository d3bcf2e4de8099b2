import { type Color, type ColorRepresentation, Vector2 } from 'three';
import type { HatchingMaterialParameters, HatchingPropertyName } from 'three-hatching';
import { HATCHING_PROPERTIES } from 'three-hatching/facts';
import type { EitherMaterial } from './NodeMakers.js';

/**
 * Returns a function that sets these parameters on a material; they are sorted by kind once for all materials. Unlike `setValues`, it does
 * not warn of properties that the present technique ignores, since the page keeps them for the next technique.
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
