import { expect, test } from 'vitest';
import { lackOfNodes, lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { PRESET_NAMES } from '../../../../src/viewer/settings/presetLabels.js';
import { presetLook } from '../../../../src/viewer/settings/presets.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

const lackOf = (changes: Partial<Settings>) => lackOfNodes({ ...defaultSettings(), ...changes });

test('materials of nodes draw every preset, with lamps, shadows that turn strokes, and the shadow on bare paper', () => {
  for (const name of PRESET_NAMES) {
    const look = presetLook(name);
    for (const shadowStrokes of ['cross', 'reorient'] as const) {
      const shadows = { shadows: 'on', shadowStrokes, ground: 'shadow' } as const;
      expect(lackOf({ ...look, ...shadows, lightKind: 'spot', secondLight: 'left' })).toBeUndefined();
    }
  }
});

test.each<[Partial<Settings>, string]>([
  [{ compare: 'engraving' }, 'a comparison'],
  [{ technique: 'triangle' }, 'this technique'],
  [{ technique: 'adjacencyCrisp' }, 'this technique'],
  [{ debugView: 'tone' }, 'views for checking'],
  [{ background: 'on' }, 'a hatched background'],
])('they lack something of %o', (changes, lack) => {
  expect(lackOf(changes)).toBe(lack);
  expect(lookOf({ ...defaultSettings(), ...changes }).lackOfNodes).toBe(lack);
});
