import type { HatchingProperty } from './HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from './hatchingProperties.js';

/** The members of three.js colours and vectors that are used here. */
interface ThreeValue {
  isColor?: boolean;
  isVector2?: boolean;
  isVector3?: boolean;
  getHex(): number;
  toArray(): number[];
}

/** A value in the form of its default: colours as numbers, vectors as arrays. */
export function plainValue(value: unknown): unknown {
  const known = value as ThreeValue | null | undefined;
  if (known?.isColor) return known.getHex();
  if (known?.isVector2 || known?.isVector3) return known.toArray();
  return value;
}

/** The default of a property under a technique. Colours are numbers, vectors arrays. */
export function defaultOf(name: HatchingPropertyName, technique: HatchingTechnique): unknown {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  const ofTechnique = 'defaultFor' in property ? property.defaultFor?.[technique] : undefined;
  return ofTechnique ?? HATCHING_DEFAULTS[name];
}

/** Whether a value, plain or not, is the default of a property. */
export const isDefault = (name: HatchingPropertyName, value: unknown, technique: HatchingTechnique): boolean =>
  JSON.stringify(plainValue(value)) === JSON.stringify(defaultOf(name, technique));
