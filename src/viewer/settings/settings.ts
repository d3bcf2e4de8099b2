import { PICTURE_SETTINGS, VIDEO_SETTINGS, VIEW_SETTINGS } from './table/outputSettings.js';
import type { NumberSetting, Setting } from './table/rows.js';
import { DRAWING_SETTINGS, OUTLINE_SETTINGS, STROKE_SETTINGS } from './table/strokeSettings.js';
import { COLOUR_SETTINGS, COMPOSITION_SETTINGS, LIGHT_SETTINGS, TONE_SETTINGS } from './table/toneSettings.js';

/** Every setting of the user, in one table of plain data. The panel, the link, the drawing and the copied code read it. */
export const SETTINGS = {
  ...DRAWING_SETTINGS,
  ...STROKE_SETTINGS,
  ...OUTLINE_SETTINGS,
  ...TONE_SETTINGS,
  ...COLOUR_SETTINGS,
  ...LIGHT_SETTINGS,
  ...COMPOSITION_SETTINGS,
  ...VIEW_SETTINGS,
  ...PICTURE_SETTINGS,
  ...VIDEO_SETTINGS,
} satisfies Record<string, Setting>;

export type SettingKey = keyof typeof SETTINGS;

/** Values of all settings: a number, one of the choices, or a colour as `#rrggbb`. */
export type Settings = {
  [Key in SettingKey]: (typeof SETTINGS)[Key] extends { kind: 'number' }
    ? number
    : (typeof SETTINGS)[Key] extends { choices: infer Choices }
      ? `${Extract<keyof Choices, string | number>}`
      : string;
};

export const SETTING_KEYS = Object.keys(SETTINGS) as SettingKey[];

/** The keys of settings with one of these owners. */
export const settingsOf = (...owners: readonly Setting['owner'][]): readonly SettingKey[] =>
  SETTING_KEYS.filter((key) => owners.includes(SETTINGS[key].owner));

/** A fresh object with every setting at its default. */
export function defaultSettings(): Settings {
  return Object.fromEntries(SETTING_KEYS.map((key) => [key, SETTINGS[key].default])) as Settings;
}

/** The allowed value of a setting that is nearest to `value`, or undefined if there is none. */
export function acceptSetting(key: SettingKey, value: string | number): string | number | undefined {
  const setting: Setting = SETTINGS[key];
  switch (setting.kind) {
    case 'number': {
      const number = Number(value);
      if (value === '' || !Number.isFinite(number)) return undefined;
      return nearestStep(setting, number);
    }
    case 'choice':
      return Object.hasOwn(setting.choices, value) ? String(value) : undefined;
    case 'color':
      return /^#[0-9a-f]{6}$/i.test(String(value)) ? String(value).toLowerCase() : undefined;
  }
}

/** The nearest value that the slider can take; its steps count from the minimum. */
function nearestStep({ min, max, step }: NumberSetting, number: number): number {
  const clamped = Math.min(max, Math.max(min, number));
  const stepped = min + Math.round((clamped - min) / step) * step;
  // Rounds off the error of floating point: 0.1 + 2 × 0.1 becomes 0.3.
  return Math.min(max, Number(stepped.toFixed(6)));
}
