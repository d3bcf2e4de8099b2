import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { acceptSetting, SETTING_KEYS, SETTINGS, type SettingKey } from '../../../../src/viewer/settings/settings.js';
import { readLink } from '../../../../src/viewer/settings/shareLink.js';
import type { Setting } from '../../../../src/viewer/settings/table/rows.js';

const settingOf = (key: SettingKey): Setting => SETTINGS[key];

describe('a setting from a link', () => {
  test.each([
    ['mapSeed', '1.5', 2],
    ['mapTones', '7.2', 7],
    ['mapSeed', '-3', 1],
    ['mapSeed', '1e9', 99],
    ['lineSpacing', '3.14159', 3.1],
    ['outlineContours', '62', 60],
    ['lightAzimuth', '-179.96', -180],
  ] as const)('%s=%s snaps to %d', (key, text, snapped) => {
    expect(readLink(`#${key}=${text}`).settings[key]).toBe(snapped);
  });

  test.each(['', 'NaN', 'Infinity', '1,5', 'seven'])('mapSeed=%s is none', (text) => {
    expect(acceptSetting('mapSeed', text)).toBeUndefined();
  });

  test('the accepted value of any number is the nearest that its slider can take', () => {
    for (const key of SETTING_KEYS) {
      const setting = settingOf(key);
      if (setting.kind !== 'number') continue;
      const { min, max, step } = setting;
      fc.assert(
        fc.property(fc.double({ min: min - 10, max: max + 10, noNaN: true }), (number) => {
          const accepted = acceptSetting(key, String(number)) as number;
          const steps = (accepted - min) / step;
          return (
            accepted >= min &&
            accepted <= max &&
            (Math.abs(steps - Math.round(steps)) < 1e-6 || accepted === max) &&
            Math.abs(accepted - Math.min(max, Math.max(min, number))) <= step / 2 + 1e-6 &&
            acceptSetting(key, accepted) === accepted
          );
        }),
        { numRuns: 200 },
      );
      expect(acceptSetting(key, setting.default), key).toBe(setting.default);
    }
  });
});
