import type { HatchingPropertyName } from 'three-hatching';

interface RowBase<Value> {
  label: string;
  default: Value;
  /** The material property that the setting controls, possibly in another unit. */
  property?: HatchingPropertyName;
  /** The material property that several settings make up together. */
  partOf?: HatchingPropertyName;
  /** A property that replaces the setting where that property has an effect. */
  yieldsTo?: HatchingPropertyName;
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
export type ChoiceSetting = ChoiceRow & Place;
export type Setting = SettingRow & Place;

/** Adds the group and the default owner to rows of the table. */
export const inGroup = <const Rows extends Readonly<Record<string, SettingRow>>>(
  group: SettingGroup,
  owner: SettingOwner,
  rows: Rows,
): { readonly [Key in keyof Rows]: Rows[Key] & Place } =>
  Object.fromEntries(Object.entries(rows).map(([key, row]) => [key, { owner, ...row, group }])) as never;
