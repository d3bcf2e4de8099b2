import { PICTURE_SETTINGS, VIDEO_SETTINGS, VIEW_SETTINGS } from './table/outputSettings.js';
import type { Setting } from './table/rows.js';
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
