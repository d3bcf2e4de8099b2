import type { Material, Texture, Vector2 } from 'three';
import { isDefault } from './defaultOf.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from './hatchingProperties.js';
import { plainValue } from './plainValue.js';

/** What three.js writes of any material, and the properties of ours that are not at their defaults. */
export type HatchingMaterialJSON = ReturnType<Material['toJSON']>;

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

/**
 * Gives a material what `toJSON` wrote. three.js writes every property by its name, so this needs none of its loaders, whose
 * ways changed over the versions. Textures are looked up by their uuid; one that is not there is left out.
 */
export function setFromJSON(
  material: HatchingMaterialProperties,
  json: HatchingMaterialJSON,
  textures: Readonly<Record<string, Texture>>,
): void {
  if (json.uuid !== undefined) Object.assign(material, { uuid: json.uuid });
  if (json.userData !== undefined) material.userData = json.userData;
  for (const [name, value] of Object.entries(json)) {
    if (NOT_SET.has(name) || !(name in material)) continue;
    const kind = HATCHING_PROPERTIES[name as HatchingPropertyName]?.kind;
    if (kind === 'texture') Object.assign(material, { [name]: textures[value as string] ?? null });
    else if (kind === 'vector2')
      (material[name as HatchingPropertyName] as Vector2).fromArray(value as [number, number]);
    else material.setValues({ [name]: value });
  }
}

/** What is set apart, or says what the JSON is. */
const NOT_SET: ReadonlySet<string> = new Set(['metadata', 'type', 'uuid', 'userData', 'textures', 'images']);
