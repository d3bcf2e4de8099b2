import { expect, test } from 'vitest';
import { withBoldnessAndDensity } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings, SETTING_KEYS } from '../../../../src/viewer/settings/settings.js';

const changedBy = (look: Parameters<typeof withBoldnessAndDensity>[0]): Record<string, number> => {
  const drawn = withBoldnessAndDensity(look);
  return Object.fromEntries(
    SETTING_KEYS.filter((key) => drawn[key] !== look[key]).map((key) => [key, Number(drawn[key]) / Number(look[key])]),
  );
};

test('boldness scales widths and spacings alike, and nothing else', () => {
  expect(changedBy({ ...defaultSettings(), boldness: 200 })).toEqual({
    strokeWidth: 2,
    lineSpacing: 2,
    outlineWidth: 2,
    tilesPerObjectUnit: 0.5,
  });
});

test('dense strokes cover more, as in less light; nothing else changes', () => {
  expect(changedBy({ ...defaultSettings(), density: 200 })).toEqual({ lightStrength: 0.5, secondStrength: 0.5 });
});

test('at 100 %, settings are unchanged', () => {
  expect(changedBy(defaultSettings())).toEqual({});
});
