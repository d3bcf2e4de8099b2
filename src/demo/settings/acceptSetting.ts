import type { Setting } from './Setting.js';
import { SETTINGS, type SettingKey } from './settings.js';

/** The allowed value of a setting that is nearest to `value`, or undefined if there is none. */
export function acceptSetting(key: SettingKey, value: string | number): string | number | undefined {
  const setting: Setting = SETTINGS[key];
  switch (setting.kind) {
    case 'number': {
      const number = Number(value);
      if (value === '' || !Number.isFinite(number)) return undefined;
      return Math.min(setting.max, Math.max(setting.min, number));
    }
    case 'choice':
      return Object.hasOwn(setting.choices, value) ? String(value) : undefined;
    case 'color':
      return /^#[0-9a-f]{6}$/i.test(String(value)) ? String(value).toLowerCase() : undefined;
  }
}
