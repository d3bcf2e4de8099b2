/**
 * What the library knows of its own properties and of what it draws, as data: for editors with a control for each property, and for
 * components that hatch. Nobody else needs it.
 *
 * @module three-hatching/facts
 */
export { HATCHING_BACKGROUND_DEFAULTS } from './background/backgroundProperties.js';
export { defaultOf } from './material/facts/defaultOf.js';
export { GLASS } from './material/facts/glass.js';
export type {
  HatchingChoice,
  HatchingCondition,
  HatchingFacts,
  HatchingMeasure,
  HatchingNumber,
  HatchingOther,
  HatchingProperty,
  HatchingSwitch,
  HatchingTechniqueData,
  HatchingTexture,
  HatchingValue,
  NumberRange,
  PlainValue,
  UsedByTechniques,
} from './material/facts/HatchingProperty.js';
export { HATCHING_FACTS } from './material/facts/hatchingFacts.js';
export { HATCHING_DEFAULTS, HATCHING_PROPERTIES } from './material/facts/hatchingProperties.js';
export {
  followsForm,
  formOf,
  type HatchingLook,
  knowsChoice,
  needsAdjacency,
  needsMap,
} from './material/facts/lookFacts.js';
export { counts, measureOf, pixelPower, scaledSizes } from './material/facts/measuredFacts.js';
export { HATCHING_OUTLINE_DEFAULTS } from './outlines/outlineProperties.js';
export { leftAlone } from './scene/leftAlone.js';
