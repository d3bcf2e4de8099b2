import type { HatchingMaterialOptions, HatchingPropertyName } from 'three-hatching';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES } from 'three-hatching/facts';
import type { ChoiceRow, ColorRow, NumberRow, SettingRow } from './Setting.js';
import { unitOf } from './units.js';

/** Names of the properties of one kind. */
type OfKind<Kind> = {
  [Name in HatchingPropertyName]: (typeof HATCHING_PROPERTIES)[Name] extends { kind: Kind } ? Name : never;
}[HatchingPropertyName];

/** The fields of a row that come from the library's table of properties. */
type Known = 'kind' | 'unit' | 'property';

/** The fields that the page supplies: all that the table lacks, and any that it overrides. */
type Added<Row extends SettingRow, Derived extends keyof Row = never> = Partial<Pick<Row, Derived | 'default'>> &
  Omit<Row, Derived | 'default' | Known>;

/** The row of a numeric material property. Fields that the page does not supply come from the table of properties, in the page's unit. */
export function numberOf(
  property: OfKind<'number'>,
  { min, max, ...added }: Added<NumberRow, 'min' | 'max' | 'step'>,
): NumberRow {
  const { range = {} } = HATCHING_PROPERTIES[property] as { range?: { from?: number; to?: number } };
  const { name, step, toSetting } = unitOf(property);
  const least = min ?? (range.from === undefined ? undefined : toSetting(range.from));
  const most = max ?? (range.to === undefined ? undefined : toSetting(range.to));
  if (least === undefined || most === undefined) {
    throw new Error(`numberOf: the range of ${property} has no end; give its row a min and a max.`);
  }
  const fallback = HATCHING_DEFAULTS[property];
  return {
    kind: 'number',
    property,
    unit: name,
    step,
    default: typeof fallback === 'number' ? toSetting(fallback) : Number.NaN,
    ...added,
    min: least,
    max: most,
  };
}

/**
 * The row of a material property with choices.
 *
 * @param leftOut values that the page does not offer
 */
export function choiceOf<
  Name extends OfKind<'choice'>,
  const Choices extends Readonly<Record<Exclude<HatchingMaterialOptions[Name], LeftOut>, string>>,
  LeftOut extends string = never,
>(
  property: Name,
  { leftOut: _leftOut, ...added }: Added<ChoiceRow> & { choices: Choices; leftOut?: readonly LeftOut[] },
): ChoiceRow & { choices: Choices } {
  const fallback = 'auto' in added.choices ? 'auto' : HATCHING_DEFAULTS[property];
  return { kind: 'choice', property, default: fallback, ...added };
}

/** The row of a colour of the material. */
export function colorOf(property: OfKind<'color'>, added: Added<ColorRow>): ColorRow {
  const fallback = `#${HATCHING_DEFAULTS[property].toString(16).padStart(6, '0')}`;
  return { kind: 'color', property, default: fallback, ...added };
}
