import { MathUtils } from 'three';
import type {
  HatchingCompositionOptions,
  HatchingMaterialOptions,
  HatchingPropertyName,
  HatchingShadowOptions,
  PerTriangleOptions,
} from 'three-hatching';
import {
  defaultOf,
  HATCHING_DEFAULTS,
  HATCHING_FACTS,
  HATCHING_OUTLINE_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingMeasure,
} from 'three-hatching/facts';
import { PAGE_DEFAULTS } from './pageDefaults.js';

interface RowBase<Value> {
  label: string;
  default: Value;
  /** The material property that the setting controls, possibly in another unit. */
  property?: HatchingPropertyName;
  /** The material property that several settings make up together. */
  partOf?: HatchingPropertyName;
  /** Has no effect on lines. */
  isForStrokes?: true;
  /** Other settings, with those of their values for which this one has an effect. */
  when?: Readonly<Record<string, readonly string[]>>;
  /** The owner, where it differs from that of the group. */
  owner?: SettingOwner;
  /** Disabled instead of hidden where it has no effect, because that depends on a slider and rows must not jump while it is dragged. */
  staysInPlace?: true;
}

export interface NumberRow extends RowBase<number> {
  kind: 'number';
  unit: string;
  min: number;
  max: number;
  step: number;
  /** Words for the lowest and the highest value, if the number alone is unclear. */
  ends?: readonly [least: string, greatest: string];
}

export interface ChoiceRow extends RowBase<string> {
  kind: 'choice';
  /** Labels by value. */
  choices: Readonly<Record<string, string>>;
}

export interface ColorRow extends RowBase<string> {
  kind: 'color';
}

export type SettingRow = NumberRow | ChoiceRow | ColorRow;

/**
 * The kind of a setting:
 * - `hand`: how strokes and lines are drawn; part of presets and of the user's saved looks
 * - `scene`: shadows, hollows and surface colours; part of saved looks, but not of presets
 * - `subject`: the model and its lights; part of no look
 * - `check`: debug views, reset by presets
 * - `output`: settings of saved pictures and videos
 */
export type SettingOwner = 'hand' | 'scene' | 'subject' | 'check' | 'output';

/** Groups of the panel, in order. The first is open, the others are folded. */
export const SETTING_GROUPS = [
  'Drawing',
  'More',
  'Outlines',
  'Tone',
  'Colours',
  'Light',
  'Composition',
  'View',
  'Picture',
  'Video',
] as const;
export type SettingGroup = (typeof SETTING_GROUPS)[number];

interface Place {
  group: SettingGroup;
  owner: SettingOwner;
}

export type NumberSetting = NumberRow & Place;
export type Setting = SettingRow & Place;

/** Adds the group and the default owner to rows of the table. */
export const inGroup = <const Rows extends Readonly<Record<string, SettingRow>>>(
  group: SettingGroup,
  owner: SettingOwner,
  rows: Rows,
): { readonly [Key in keyof Rows]: Rows[Key] & Place } =>
  Object.fromEntries(Object.entries(rows).map(([key, row]) => [key, { owner, ...row, group }])) as never;

/** How the page shows a numeric material property. */
export interface Unit {
  name: string;
  /** Default step of its slider. */
  step: number;
  toProperty(setting: number): number;
  toSetting(property: number): number;
}

/** Rounds off the error of floating point: 55 % instead of 55.00000000000001 %. */
const rounded = (value: number): number => Number(value.toFixed(6));

const asIs = (name: string, step: number): Unit => ({
  name,
  step,
  toProperty: (setting) => setting,
  toSetting: (value) => value,
});

const PERCENT: Unit = {
  name: '%',
  step: 1,
  toProperty: (setting) => setting / 100,
  toSetting: (value) => rounded(100 * value),
};

/** Units by the measure of a property. */
export const UNITS: Readonly<Record<HatchingMeasure, Unit>> = {
  pixels: asIs('px', 0.1),
  gridPixels: asIs('px', 0.1),
  radians: {
    name: '°',
    step: 1,
    toProperty: MathUtils.degToRad,
    toSetting: (value) => rounded(MathUtils.radToDeg(value)),
  },
  tiles: asIs('tiles', 0.01),
  tileParts: asIs('/256 tile', 0.1),
  tilesPerObjectUnit: asIs('tiles', 0.1),
  share: PERCENT,
  depths: PERCENT,
  worldUnits: asIs('radii', 0.01),
  tone: PERCENT,
  factor: asIs('', 0.1),
  count: asIs('', 1),
  exponent: asIs('', 1),
};

/** The unit of a property on the page. Properties that can be sized on the screen are shown in pixels. */
export function unitOf(property: HatchingPropertyName): Unit {
  const { measure, measureOnScreen = measure } = HATCHING_FACTS[property] ?? {};
  if (measureOnScreen === undefined) throw new Error(`unitOf: ${property} is no number.`);
  return UNITS[measureOnScreen];
}

/** Names of the properties of one kind. */
type OfKind<Kind> = {
  [Name in HatchingPropertyName]: (typeof HATCHING_PROPERTIES)[Name] extends { kind: Kind } ? Name : never;
}[HatchingPropertyName];

/** The fields of a row that come from the library's table of properties. */
type Known = 'kind' | 'unit' | 'property' | 'default';

/** The fields that the page supplies: all that the table lacks, and any that it overrides. */
type Added<Row extends SettingRow, Derived extends keyof Row = never> = Partial<Pick<Row, Derived>> &
  Omit<Row, Derived | Known>;

/** The library's default of a property, under its default technique. */
export const libraryDefault = (property: HatchingPropertyName): unknown =>
  defaultOf(property, HATCHING_DEFAULTS.technique);

/** The page's own default of a property, or the library's in the form of a setting. */
const defaultFor = <Value>(property: HatchingPropertyName, toSetting: (value: unknown) => Value): Value =>
  property in PAGE_DEFAULTS
    ? (PAGE_DEFAULTS[property as keyof typeof PAGE_DEFAULTS] as Value)
    : toSetting(libraryDefault(property));

/** The row of a share in percent, which belongs to the page alone. */
export const percent = (label: string, fallback: number, added: Partial<NumberRow> = {}): NumberRow => ({
  kind: 'number',
  label,
  default: fallback,
  unit: '%',
  min: 0,
  max: 100,
  step: 1,
  ...added,
});

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
  return {
    kind: 'number',
    property,
    unit: name,
    step,
    default: defaultFor(property, (value) => toSetting(Number(value))),
    ...added,
    min: least,
    max: most,
  };
}

/** The properties of the material, and of the objects that own others. */
type AllOptions = HatchingMaterialOptions & HatchingCompositionOptions & PerTriangleOptions & HatchingShadowOptions;

/**
 * The row of a material property with choices.
 *
 * @param leftOut values that the page does not offer
 */
export function choiceOf<
  Name extends OfKind<'choice'>,
  const Choices extends Readonly<Record<Exclude<AllOptions[Name], LeftOut>, string>>,
  LeftOut extends string = never,
>(
  property: Name,
  { leftOut: _leftOut, ...added }: Added<ChoiceRow> & { choices: Choices; leftOut?: readonly LeftOut[] },
): ChoiceRow & { choices: Choices } {
  // `'auto'` leaves a property with a default for each technique to the technique.
  const isLeft = 'auto' in added.choices && 'defaultFor' in HATCHING_PROPERTIES[property];
  return {
    kind: 'choice',
    property,
    default: defaultFor(property, (value) => (isLeft ? 'auto' : String(value))),
    ...added,
  };
}

/** The row of a colour of the material. */
export function colorOf(property: OfKind<'color'>, added: Added<ColorRow>): ColorRow {
  const hex = (value: unknown): string => `#${Number(value).toString(16).padStart(6, '0')}`;
  return { kind: 'color', property, default: defaultFor(property, hex), ...added };
}

/** The default of a number or a weight of `HatchingOutlineMaterial`. */
const OUTLINE_NUMBERS = { ...HATCHING_OUTLINE_DEFAULTS, ...HATCHING_OUTLINE_DEFAULTS.weights };

/** The row of a number of `HatchingOutlineMaterial`: a weight or a share in percent, or a size in pixels. */
export function outlineOf(
  property: Exclude<keyof typeof OUTLINE_NUMBERS, 'weights' | 'ink' | 'hidden'>,
  unit: '%' | 'px',
  added: Partial<Omit<NumberRow, 'default'>> & { label: string },
): NumberRow {
  const fallback = OUTLINE_NUMBERS[property];
  const range = unit === '%' ? { min: 0, max: 200, step: 5 } : { min: 0, max: 8, step: 0.1 };
  const value = unit === '%' ? UNITS.share.toSetting(fallback) : fallback;
  return { kind: 'number', when: { outlines: ['on'] }, unit, default: value, ...range, ...added };
}
