import type { HatchingProperty } from './HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from './hatchingProperties.js';
import { plainValue } from './plainValue.js';

/** The default of a property; some techniques have one of their own. Colours are numbers, vectors arrays. */
export function defaultOf(name: HatchingPropertyName, technique: HatchingTechnique): unknown {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  const ofTechnique = 'defaultFor' in property ? property.defaultFor?.[technique] : undefined;
  return ofTechnique ?? HATCHING_DEFAULTS[name];
}

/** Whether a value, plain or not, is the default of a property. */
export const isDefault = (name: HatchingPropertyName, value: unknown, technique: HatchingTechnique): boolean =>
  JSON.stringify(plainValue(value)) === JSON.stringify(defaultOf(name, technique));
