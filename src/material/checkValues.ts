import type { MaterialParameters, NormalMapTypes } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type HatchingTechnique } from '../look/hatchingProperties.js';
import type { PresetName } from '../look/presetMaterials.js';
import { isDefault } from '../look/presetParameters.js';
import { isUsedBy } from '../look/queries.js';
import { checkOwned, checkValue, ownedEntries, ownerOf } from './checkProperty.js';
import { warn } from './diagnostics/warn.js';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';

/** The parameters of `new HatchingMaterial()` and `setValues()`. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    /**
     * The name of the preset to start from. The other parameters override it one by one; properties that the preset does not set have
     * their defaults.
     */
    preset?: PresetName | undefined;
    /** Defines of your own, added to those of the material. */
    defines?: Record<string, unknown> | undefined;
    /** The space of `normalMap`: `TangentSpaceNormalMap`, the default, or `ObjectSpaceNormalMap`. */
    normalMapType?: NormalMapTypes | undefined;
    fog?: boolean | undefined;
    wireframe?: boolean | undefined;
    clipping?: boolean | undefined;
    lights?: boolean | undefined;
  };

/**
 * Checks parameters before any of them is set, so that a wrong one changes nothing. Parameters of three's `Material` are not checked.
 *
 * @throws TypeError, RangeError or Error naming the first property of the library whose value is of the wrong kind or out of its range
 */
export function checkValues(parameters: HatchingMaterialParameters): void {
  // An object read from JSON may have this as an own property, and three.js would set it as the prototype of the material.
  if (Object.hasOwn(parameters, '__proto__')) throw new TypeError('HatchingMaterial: "__proto__" is no parameter.');
  if (Object.hasOwn(parameters, 'material')) {
    throw new TypeError('HatchingMaterial: this is a whole preset. Pass its material: presets.pen.material.');
  }
  for (const [name, value] of Object.entries(parameters)) {
    // three.js itself warns of undefined values, and keeps the present ones.
    if (value === undefined) continue;
    if (name === 'composition' || name === 'perTriangle') checkOwned(name, value);
    else if (Object.hasOwn(HATCHING_PROPERTIES, name)) {
      const { owner }: HatchingProperty = HATCHING_PROPERTIES[name as HatchingPropertyName];
      if (owner === 'composition' || owner === 'perTriangle')
        throw new TypeError(`HatchingMaterial: "${name}" belongs to ${owner}. Pass { ${owner}: { ${name} } }.`);
      checkValue(name as HatchingPropertyName, value);
    }
  }
}

const warned = new Set<string>();

/** Warns once of each parameter that is set but not used by the technique. */
export function warnOfUnused(parameters: HatchingMaterialParameters, technique: HatchingTechnique): void {
  const { perTriangle = {} } = parameters;
  for (const [key, value] of [...Object.entries(parameters), ...ownedEntries('perTriangle', perTriangle)]) {
    if (!Object.hasOwn(HATCHING_PROPERTIES, key)) continue;
    const name = key as HatchingPropertyName;
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    // A map may be set for any technique: materials share it.
    if (property.kind === 'tonalArtMap') continue;
    const warning = `${name} ${technique}`;
    if (isUsedBy(technique, property) || warned.has(warning) || isDefault(name, value, technique)) continue;
    warned.add(warning);
    warn(
      `${ownerOf(name)}: "${name}" is not used by the technique "${technique}", only by ${property.techniques?.join(' and ')}.`,
    );
  }
}
