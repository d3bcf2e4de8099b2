import type { Color, Vector2 } from 'three';
import { defaultOf } from './defaultOf.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from './hatchingProperties.js';

/**
 * The properties of a material that are not at their defaults, as JSON: colours as numbers, vectors as arrays. Textures are
 * left to three's own `Material.toJSON`; the tonal art map is left out.
 */
export function propertiesToJSON(material: HatchingMaterialProperties): Record<string, unknown> {
  const json: Record<string, unknown> = {};
  for (const [name, { kind }] of Object.entries(HATCHING_PROPERTIES)) {
    if (kind === 'texture' || kind === 'tonalArtMap') continue;
    const value = plainValue(material[name as HatchingPropertyName]);
    const fallback = defaultOf(name as HatchingPropertyName, material.technique);
    if (JSON.stringify(value) !== JSON.stringify(fallback)) json[name] = value;
  }
  return json;
}

function plainValue(value: unknown): unknown {
  if ((value as Color | null)?.isColor) return (value as Color).getHex();
  if ((value as Vector2 | null)?.isVector2) return (value as Vector2).toArray();
  return value;
}
