import { isDefault } from '../look/defaultOf.js';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type HatchingTechnique } from '../look/hatchingProperties.js';
import { isUsedBy } from '../look/queries.js';
import { warn } from './diagnostics/warn.js';
import type { HatchingMaterialParameters } from './HatchingMaterialParameters.js';

const warned = new Set<string>();

/** Warns once of each parameter that is set but not used by the technique. */
export function warnOfUnused(parameters: HatchingMaterialParameters, technique: HatchingTechnique): void {
  for (const name of Object.keys(parameters)) {
    if (!Object.hasOwn(HATCHING_PROPERTIES, name)) continue;
    const property: HatchingProperty = HATCHING_PROPERTIES[name as HatchingPropertyName];
    // A map may be set for any technique: materials share it.
    if (property.kind === 'tonalArtMap') continue;
    const key = `${name} ${technique}`;
    if (isUsedBy(technique, property) || warned.has(key)) continue;
    if (isDefault(name as HatchingPropertyName, parameters[name as HatchingPropertyName], technique)) continue;
    warned.add(key);
    warn(
      `HatchingMaterial: "${name}" is not used by the technique "${technique}", only by ${property.techniques?.join(' and ')}.`,
    );
  }
}
