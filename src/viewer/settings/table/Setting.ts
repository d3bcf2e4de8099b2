import type { HatchingPropertyName } from 'three-hatching';

interface RowBase<Value> {
  label: string;
  default: Value;
  /** The property of the material that the setting is, in another unit perhaps. */
  property?: HatchingPropertyName;
  /** The property of the material that several settings are together. */
  partOf?: HatchingPropertyName;
  /** A property that takes the place of the setting where it counts itself. */
  yieldsTo?: HatchingPropertyName;
  /** Other settings, and the values of theirs with which this one has an effect. */
  when?: Readonly<Record<string, readonly string[]>>;
  /** Whose it is, where that differs from the others of its group. */
  owner?: SettingOwner;
  /** Disabled, and not hidden, where it has no effect: that depends on a slider, and rows must not jump while it is dragged. */
  staysInPlace?: true;
}

export interface NumberRow extends RowBase<number> {
  kind: 'number';
  unit: string;
  min: number;
  max: number;
  step: number;
  /** What the least and the greatest value mean, in a word or two each, if the number alone does not say it. */
  ends?: readonly [least: string, greatest: string];
}

export interface ChoiceRow extends RowBase<string> {
  kind: 'choice';
  /** The label of each value. */
  choices: Readonly<Record<string, string>>;
}

export interface ColorRow extends RowBase<string> {
  kind: 'color';
}

export type SettingRow = NumberRow | ChoiceRow | ColorRow;

/**
 * Whose a setting is:
 * - `hand`: how strokes and lines are drawn, which presets and the user's own looks set
 * - `scene`: shadows, hollows and the colours of surfaces, which the user's own looks set, but presets leave alone
 * - `subject`: what is drawn and from where it is lit, which no look sets
 * - `check`: for looking into a drawing, which presets end
 * - `output`: the picture or the video that is saved
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

/** Rows of one group of the panel. */
export const inGroup = <const Rows extends Readonly<Record<string, SettingRow>>>(
  group: SettingGroup,
  owner: SettingOwner,
  rows: Rows,
): { readonly [Key in keyof Rows]: Rows[Key] & Place } =>
  Object.fromEntries(Object.entries(rows).map(([key, row]) => [key, { owner, ...row, group }])) as never;
