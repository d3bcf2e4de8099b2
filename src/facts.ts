/**
 * What the library knows of its own properties and of what it draws, as data: for editors with a control for each property, and for
 * components that hatch. Nobody else needs it.
 *
 * @module three-hatching/facts
 */

export { GLASS, paperOfGlass } from './look/glass.js';
export type {
  HatchingChoice,
  HatchingCondition,
  HatchingFacts,
  HatchingMeasure,
  HatchingNumber,
  HatchingOther,
  HatchingOwner,
  HatchingProperty,
  HatchingSwitch,
  HatchingTechniqueData,
  HatchingTexture,
  HatchingValue,
  NumberRange,
  PlainValue,
  TechniqueFamily,
  UsedByTechniques,
} from './look/HatchingProperty.js';
export { HATCHING_FACTS } from './look/hatchingFacts.js';
export { HATCHING_DEFAULTS, HATCHING_PROPERTIES } from './look/hatchingProperties.js';
export { counts, measureOf, pixelPower, scaledSizes } from './look/measuredFacts.js';
export { type Metal, mirroredShare } from './look/mirrors.js';
export { defaultOf } from './look/presetParameters.js';
export {
  drawsLines,
  followsForm,
  formOf,
  givenValue,
  type HatchingLook,
  knowsChoice,
  needsAdjacency,
  needsMap,
  parametersOf,
} from './look/queries.js';
export { HATCHING_BACKGROUND_DEFAULTS } from './material/backgroundProperties.js';
export { HATCHING_OUTLINE_DEFAULTS } from './material/outlines/outlineProperties.js';
export { leftAlone } from './scene/leftAlone.js';
