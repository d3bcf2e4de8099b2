import { isDefault } from './defaultOf.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from './hatchingProperties.js';
import { plainValue } from './plainValue.js';

/**
 * The properties of a material that are not at their defaults, as JSON: colours as numbers, vectors as arrays. Textures are
 * left to three's own `Material.toJSON`; the tonal art map is left out.
 */
export function propertiesToJSON(material: HatchingMaterialProperties): Record<string, unknown> {
  const json: Record<string, unknown> = {};
  for (const [name, { kind }] of Object.entries(HATCHING_PROPERTIES)) {
    if (kind === 'texture' || kind === 'tonalArtMap') continue;
    const value = plainValue(material[name as HatchingPropertyName]);
    if (!isDefault(name as HatchingPropertyName, value, material.technique)) json[name] = value;
  }
  return json;
}
