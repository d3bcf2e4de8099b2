import { readdirSync, readFileSync, statSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { GALLERY } from '../../../../src/viewer/settings/gallery.js';
import { PRESET_NAMES } from '../../../../src/viewer/settings/presetLabels.js';
import { presetLook } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings, SETTINGS, type SettingKey } from '../../../../src/viewer/settings/settings.js';
import { readLink, writeLink } from '../../../../src/viewer/settings/shareLink.js';
import { surprise } from '../../../../src/viewer/settings/surprise.js';

const FOLDER = new URL('../../../../public/gallery/', import.meta.url);
const MAX_BYTES = 300_000;

describe('the gallery', () => {
  test.each(GALLERY.map((drawing) => [drawing.title, drawing] as const))(
    '%s: its link says what is drawn',
    (_, { link }) => {
      const parameters = [...new URLSearchParams(link)];
      const { settings } = readLink(link);
      expect(PRESET_NAMES).toContain(new URLSearchParams(link).get('preset'));
      for (const [key, value] of parameters) {
        if (key === 'preset') continue;
        expect(key in SETTINGS, key).toBe(true);
        expect(String(settings[key as SettingKey]), key).toBe(value);
      }
      // A link of the page itself gives back the same.
      expect(readLink(writeLink(settings, undefined)).settings).toEqual(settings);
    },
  );

  test('has a small WebP picture of each drawing and each preset, and no others', () => {
    const names = [...GALLERY.map(({ name }) => name), ...PRESET_NAMES.map((name) => `preset-${name}`)];
    const files = readdirSync(FOLDER);
    expect(files.sort()).toEqual(names.map((name) => `${name}.webp`).sort());
    for (const file of files) expect(readFileSync(new URL(file, FOLDER)).subarray(8, 12).toString()).toBe('WEBP');
    expect(files.reduce((sum, file) => sum + statSync(new URL(file, FOLDER)).size, 0)).toBeLessThan(MAX_BYTES);
  });
});

describe('a surprise', () => {
  const before = { ...defaultSettings(), ...presetLook('pen'), model: 'vase' } as const;

  test('is the same for the same seed, and another for others', () => {
    expect(surprise(before, 7)).toEqual(surprise(before, 7));
    const seen = new Set(Array.from({ length: 20 }, (_, seed) => JSON.stringify(surprise(before, seed))));
    expect(seen.size).toBe(20);
  });

  test('keeps model and view, never the hand, and lights from above and in front', () => {
    for (let seed = 0; seed < 200; seed++) {
      const after = surprise(before, seed);
      expect(after.model).toBe('vase');
      expect(after.upAxis).toBe(before.upAxis);
      expect(after.lightElevation).toBeGreaterThan(10);
      expect(Math.abs(after.lightAzimuth)).toBeLessThan(90);
      const { ink: _ink, paper: _paper, boldness: _boldness, density: _density, ...look } = presetLook('pen');
      expect(after).not.toMatchObject(look);
      // What a link can carry.
      expect(readLink(writeLink(after, undefined)).settings).toEqual(after);
    }
  });
});
