import { defaultOf } from './defaultOf.js';
import type { HatchingCondition, HatchingFacts, HatchingMeasure, HatchingProperty } from './HatchingProperty.js';
import { HATCHING_FACTS } from './hatchingFacts.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  HATCHING_TECHNIQUES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from './hatchingProperties.js';
import type { PresetName } from './presetMaterials.js';
import { spelledOut } from './presetParameters.js';

/**
 * What follows from the properties of a look, by the tables of properties and techniques. Whoever has to know asks here.
 *
 * A look is a `HatchingMaterial` or parameters of one; what is left out is as in the preset that they name, or at its default.
 */
export type HatchingLook = { readonly [Name in HatchingPropertyName]?: unknown } & {
  readonly preset?: PresetName | undefined;
};

const NAMES = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const propertyOf = (name: HatchingPropertyName): HatchingProperty => HATCHING_PROPERTIES[name];
const factsOf = (name: HatchingPropertyName): HatchingFacts => HATCHING_FACTS[name] ?? {};

const techniqueOf = ({ technique = HATCHING_DEFAULTS.technique }: HatchingLook) => technique as HatchingTechnique;

/** Whether a property is one of those that the technique of a look reads. Allocates nothing. */
export const isUsedBy = (technique: HatchingTechnique, { techniques }: HatchingProperty): boolean =>
  techniques?.includes(technique) ?? true;

/** Whether a choice is one of those that a technique knows. Allocates nothing. */
export const knowsChoice = (technique: HatchingTechnique, property: HatchingProperty, value: unknown): boolean =>
  property.kind !== 'choice' || (property.choicesFor?.[technique]?.includes(value as string) ?? true);

/** Whether a property counts for a look: its technique reads it, and so do its medium and what else it depends on. */
export function counts(given: HatchingLook, name: HatchingPropertyName): boolean {
  const look = spelledOut(given);
  if (!isUsedBy(techniqueOf(look), propertyOf(name))) return false;
  const { when = {} } = factsOf(name);
  return [when].flat().some((condition) => holds(look, condition));
}

const holds = (look: HatchingLook, condition: HatchingCondition): boolean =>
  Object.entries(condition).every(([key, values]) => {
    const name = key as HatchingPropertyName;
    if (!isUsedBy(techniqueOf(look), propertyOf(name))) return true;
    const value = valueIn(look, name);
    return 'not' in values ? value !== values.not : (values as readonly unknown[]).includes(value);
  });

/** Whether a look is drawn with a tonal art map. Without one it would be blank paper. */
export function needsMap(given: HatchingLook): boolean {
  const look = spelledOut(given);
  const { tonalArtMap } = HATCHING_PROPERTIES;
  return isUsedBy(techniqueOf(look), tonalArtMap) && holds(look, tonalArtMap.when);
}

/** Whether a look decides ink from the thresholds of its map, and not from the greys of its strokes. Allocates nothing. */
export function usesThresholds(given: HatchingLook): boolean {
  const look = spelledOut(given);
  const technique = techniqueOf(look);
  if (HATCHING_TECHNIQUES[technique].map === 'thresholdMap') return true;
  return look.crisp === true && isUsedBy(technique, HATCHING_PROPERTIES.crisp);
}

/** Whether a look draws only geometries that were prepared with triangle adjacency. */
export const needsAdjacency = (look: HatchingLook): boolean =>
  HATCHING_TECHNIQUES[techniqueOf(spelledOut(look))].vertexData === 'adjacency';

/** The property by which the lines or strokes of a look may follow the form; undefined if they cannot. Allocates nothing. */
export function formFieldOf(given: HatchingLook): 'lineField' | 'strokeField' | undefined {
  const look = spelledOut(given);
  const technique = techniqueOf(look);
  if (isUsedBy(technique, HATCHING_PROPERTIES.lineField)) return 'lineField';
  // Dots have no direction.
  const hasStrokes = isUsedBy(technique, HATCHING_PROPERTIES.strokeField) && look.medium !== 'stipple';
  return hasStrokes ? 'strokeField' : undefined;
}

/** What a look asks of geometries: `form` of `prepareHatchingGeometry`. Allocates nothing. */
export function formOf(given: HatchingLook): boolean | 'auto' {
  const look = spelledOut(given);
  const name = formFieldOf(look);
  const field = name && look[name];
  return field === 'auto' ? field : field === 'form' || field === 'acrossForm';
}

/** Whether lines or strokes of a look follow the form, which only geometries show that were prepared with `form`. Allocates nothing. */
export const followsForm = (look: HatchingLook): boolean => formOf(look) !== false;

/**
 * What a number or a vector measures in a look; undefined for other properties, and for one that is a mean of two measures, as far as
 * `sizedOnScreen` says.
 */
export function measureOf(look: HatchingLook, name: HatchingPropertyName): HatchingMeasure | undefined {
  const { measure, measureOnScreen = measure } = factsOf(name);
  const onScreen = Number(valueIn(spelledOut(look), 'sizedOnScreen'));
  if (measure === measureOnScreen || onScreen === 0) return measure;
  return onScreen === 1 ? measureOnScreen : undefined;
}

/**
 * How a property goes with the size of a picture: 1 if it is measured in CSS pixels, 0 if it is not, and for one that is as far as
 * `sizedOnScreen` says, that. In a picture twice as wide it is 2 to this power as large.
 */
export function pixelPower(look: HatchingLook, name: HatchingPropertyName): number {
  const { measure, measureOnScreen } = factsOf(name);
  if (measure === 'pixels') return 1;
  return measureOnScreen === 'pixels' ? Number(valueIn(spelledOut(look), 'sizedOnScreen')) : 0;
}

/**
 * The sizes that are numbers in a look, and measured in CSS pixels, for a larger or smaller picture that shows the same. Another pixel
 * ratio of the renderer needs none of this.
 *
 * @param factor the width of that picture, divided by that of the one that the sizes are for, both at the same pixel ratio
 */
export function scaledSizes<Look extends HatchingLook>(given: Look, factor: number): Partial<Look> {
  const look = spelledOut(given);
  const sizes: Partial<Record<HatchingPropertyName, number>> = {};
  for (const name of NAMES) {
    const value = look[name];
    const power = pixelPower(look, name);
    if (typeof value !== 'number' || power === 0) continue;
    const { range } = propertyOf(name) as { range?: { from?: number } };
    sizes[name] = Math.max(value * factor ** power, range?.from ?? 0);
  }
  return sizes as Partial<Look>;
}

function valueIn(look: HatchingLook, name: HatchingPropertyName): unknown {
  const value = look[name];
  const technique = techniqueOf(look);
  const isChosen = value !== undefined && value !== 'auto' && knowsChoice(technique, propertyOf(name), value);
  return isChosen ? value : defaultOf(name, technique);
}
