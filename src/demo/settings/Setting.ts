interface SettingBase<Value> {
  label: string;
  default: Value;
  group: SettingGroup;
}

export interface NumberSetting extends SettingBase<number> {
  kind: 'number';
  unit: string;
  min: number;
  max: number;
  step: number;
  /** What the least and the greatest value mean, in a word or two each, if the number alone does not say it. */
  ends?: readonly [least: string, greatest: string];
}

export interface ChoiceSetting extends SettingBase<string> {
  kind: 'choice';
  /** The label of each value. */
  choices: Readonly<Record<string, string>>;
}

export interface ColorSetting extends SettingBase<string> {
  kind: 'color';
}

export type Setting = NumberSetting | ChoiceSetting | ColorSetting;

/** Groups of the panel, in order. The first is open, the others are folded. */
export const SETTING_GROUPS = [
  'Drawing',
  'More',
  'Lines',
  'Tone',
  'Colours',
  'Light',
  'View',
  'Picture',
  'Video',
] as const;
export type SettingGroup = (typeof SETTING_GROUPS)[number];
