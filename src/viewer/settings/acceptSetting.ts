import { SETTINGS, type SettingKey } from './settings.js';
import type { NumberSetting, Setting } from './table/rows.js';

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
