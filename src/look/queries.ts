import type { HatchingCondition, HatchingProperty } from './HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  HATCHING_TECHNIQUES,
  type HatchingPropertyName,
  type HatchingTechnique,
  type PropertyNameOf,
  type ShadowStrokes,
  type StrokeDirection,
  type StrokeLayers,
} from './hatchingProperties.js';
import type { PresetName } from './presetMaterials.js';
import { defaultOf, familyOf, spelledOut } from './presetParameters.js';

/**
 * A `HatchingMaterial` or parameters of one. Members left out have the value of the named preset, or their default. The functions of this
 * file derive facts about a look from the tables of properties and techniques; `measuredFacts.ts` has those about measures.
 */
export type HatchingLook = { readonly [Name in PropertyNameOf<undefined | 'shadowMaterial'>]?: unknown } & {
  readonly preset?: PresetName | undefined;
  readonly composition?: { readonly [Name in PropertyNameOf<'composition'>]?: unknown } | undefined;
  readonly perTriangle?: { readonly [Name in PropertyNameOf<'perTriangle'>]?: unknown } | undefined;
  /** Whether it is the look of a `HatchingShadowMaterial`. */
  readonly isHatchingShadowMaterial?: boolean;
};

/** The entry of a property in the table. */
export const propertyOf = (name: HatchingPropertyName): HatchingProperty => HATCHING_PROPERTIES[name];

/** The technique of a look. */
export const techniqueOf = ({ technique = HATCHING_DEFAULTS.technique }: HatchingLook) =>
  technique as HatchingTechnique;

/** Whether a technique draws lines: engraved, in strokes of a pen, or cut in wood. */
export const drawsLines = (technique: HatchingTechnique): boolean => familyOf(technique) === 'lines';

/** Whether a look draws the strokes of a hand in rows. Allocates nothing. */
export const drawsHand = (look: Pick<HatchingLook, 'technique' | 'hand'>): boolean =>
  techniqueOf(look) === 'pen' && (look.hand ?? null) !== null;

/** Whether a technique reads a property. Allocates nothing. */
export const isUsedBy = (technique: HatchingTechnique, { techniques }: HatchingProperty): boolean =>
  techniques?.includes(technique) ?? true;

/** Whether a technique knows a choice. Allocates nothing. */
export const knowsChoice = (technique: HatchingTechnique, property: HatchingProperty, value: unknown): boolean =>
  property.kind !== 'choice' || (property.choicesFor?.[familyOf(technique)]?.includes(value as string) ?? true);

/** Whether a condition on other properties holds for a look. */
export const holds = (look: HatchingLook, condition: HatchingCondition): boolean =>
  Object.entries(condition).every(([key, values]) => {
    const name = key as HatchingPropertyName;
    if (!isUsedBy(techniqueOf(look), propertyOf(name))) return true;
    const value = valueIn(look, name);
    return 'not' in values ? value !== values.not : (values as readonly unknown[]).includes(value);
  });

/** Whether a look is drawn with a tonal art map, without which it would be blank paper. */
export const needsMap = (look: HatchingLook): boolean =>
  HATCHING_TECHNIQUES[techniqueOf(spelledOut(look))].map !== 'none';

/** Whether a look decides ink by the thresholds of its map instead of the greys of its strokes. Allocates nothing. */
export function usesThresholds(given: HatchingLook): boolean {
  const look = spelledOut(given);
  const technique = techniqueOf(look);
  if (HATCHING_TECHNIQUES[technique].map === 'thresholdMap') return true;
  return look.perTriangle?.sharpInk === true && isUsedBy(technique, HATCHING_PROPERTIES.sharpInk);
}

/** Whether a look needs geometries prepared with triangle adjacency. */
export const needsAdjacency = (look: HatchingLook): boolean =>
  familyOf(techniqueOf(spelledOut(look))) === 'perTriangle';

/** Whether an owner of properties is a part of a look, as the numbers of shadows are of a `HatchingShadowMaterial` alone. */
export const hasOwner = (look: HatchingLook, { owner }: HatchingProperty): boolean =>
  owner !== 'shadowMaterial' || look.isHatchingShadowMaterial === true;

/** Whether a look shows shadows alone, in one layer of strokes that run away from the light. Allocates nothing. */
export function runsAway(given: HatchingLook): boolean {
  const look = spelledOut(given);
  return look.isHatchingShadowMaterial === true && valueIn(look, 'shadowDirection') === 'away';
}

/** The option `form` of `prepareHatchingGeometry` that a look needs. Allocates nothing. */
export function formOf(given: HatchingLook): boolean | 'auto' {
  const look = spelledOut(given);
  if (runsAway(look) || !isUsedBy(techniqueOf(look), HATCHING_PROPERTIES.direction)) return false;
  const direction = valueIn(look, 'direction');
  return direction === 'auto' ? direction : direction === 'form' || direction === 'acrossForm';
}

/** Whether lines or strokes of a look follow the form, which needs geometries prepared with `form`. Allocates nothing. */
export const followsForm = (look: HatchingLook): boolean => formOf(look) !== false;

/** The value of a property in a look, wherever it lies; undefined if the look does not set it. Allocates nothing. */
export function givenValue(look: HatchingLook, name: HatchingPropertyName): unknown {
  const { owner } = propertyOf(name);
  const holder = owner === 'composition' || owner === 'perTriangle' ? look[owner] : look;
  return (holder as Readonly<Partial<Record<HatchingPropertyName, unknown>>> | undefined)?.[name];
}

/** Values of properties by name as a look, in which those of a composition and of the paper's techniques lie in objects of their own. */
export function parametersOf(values: Readonly<Record<string, unknown>>): Record<string, unknown> {
  const parameters: Record<string, unknown> = {};
  const table: Readonly<Record<string, HatchingProperty>> = HATCHING_PROPERTIES;
  for (const [name, value] of Object.entries(values)) {
    const owner = Object.hasOwn(table, name) ? table[name].owner : undefined;
    if (owner === 'composition' || owner === 'perTriangle')
      parameters[owner] = { ...Object(parameters[owner]), [name]: value };
    else parameters[name] = value;
  }
  return parameters;
}

/** The effective value of a property in a look. */
export function valueIn(look: HatchingLook, name: HatchingPropertyName): unknown {
  const value = givenValue(look, name);
  const technique = techniqueOf(look);
  const property = propertyOf(name);
  const isLeftToTechnique = value === 'auto' && 'defaultFor' in property;
  const isChosen = value !== undefined && !isLeftToTechnique && knowsChoice(technique, property, value);
  return isChosen ? value : defaultOf(name, technique);
}

/** The choices that are drawn on a mesh; one that does not count for the technique is at its default. */
export interface ResolvedLook {
  readonly technique: HatchingTechnique;
  readonly direction: Exclude<StrokeDirection, 'auto'>;
  readonly shadowStrokes: ShadowStrokes;
  readonly strokeLayers: StrokeLayers;
  /** Whether the look shows shadows alone, in one layer of strokes that run away from the light. */
  readonly runsAway: boolean;
}

/** The settings of strokes of shadows that run away from the light; they override the look of the model's strokes. */
const AWAY: Partial<Record<HatchingPropertyName, string>> = {
  direction: 'light',
  shadowStrokes: 'tone',
  strokeLayers: 'single',
};

/** The direction of lines that would follow the form, by their technique, on meshes that were prepared without it. */
const withoutForm = (technique: HatchingTechnique): StrokeDirection =>
  technique === 'pen' ? 'slant' : technique === 'woodcut' ? 'towardsLight' : 'light';

/**
 * The value of a property that a look is drawn with: its own where it counts for the technique, or else the technique's default. Lines and
 * strokes follow the form only on meshes that were prepared with it. Allocates nothing.
 *
 * @param look a material, or parameters of one without a preset
 * @param hasForm whether the mesh was prepared with `form`
 */
export function drawnValue(look: HatchingLook, name: HatchingPropertyName, hasForm: boolean): unknown {
  const technique = techniqueOf(look);
  const counts = isUsedBy(technique, propertyOf(name));
  const value = (runsAway(look) && AWAY[name]) || (counts ? valueIn(look, name) : defaultOf(name, technique));
  if (name !== 'direction') return value;
  const form = formOf(look);
  if (form === 'auto') return hasForm ? 'form' : withoutForm(technique);
  return form && !hasForm ? 'light' : value;
}

/**
 * How a look is drawn on a mesh.
 *
 * @param look a material, or parameters of one without a preset
 * @param hasForm whether the mesh was prepared with `form`
 */
export function resolveLook(look: HatchingLook, hasForm: boolean): ResolvedLook {
  const drawn = <Choice>(name: HatchingPropertyName): Choice => drawnValue(look, name, hasForm) as Choice;
  return {
    technique: techniqueOf(look),
    direction: drawn('direction'),
    shadowStrokes: drawn('shadowStrokes'),
    strokeLayers: drawn('strokeLayers'),
    runsAway: runsAway(look),
  };
}
