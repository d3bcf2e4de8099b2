import { expect, test } from 'vitest';
import { lackOfNodes } from '../../../src/settings/lackOfNodes.js';
import { lookOf } from '../../../src/settings/lookOf.js';
import { PRESET_NAMES } from '../../../src/settings/presetLabels.js';
import { presetLook } from '../../../src/settings/presets.js';
import { defaultSettings, type Settings } from '../../../src/settings/settings.js';

const lackOf = (changes: Partial<Settings>) => lackOfNodes({ ...defaultSettings(), ...changes });

test('materials of nodes draw every preset, with lamps, shadows and a floor', () => {
  for (const name of PRESET_NAMES) {
    const look = presetLook(name);
    expect(lackOf({ ...look, shadows: 'on', ground: 'floor', lightKind: 'spot', secondLight: 'left' })).toBeUndefined();
  }
});

test.each<[Partial<Settings>, string]>([
  [{ compare: 'engraved' }, 'a comparison'],
  [{ technique: 'triangle' }, 'this technique'],
  [{ technique: 'adjacencyCrisp' }, 'this technique'],
  [{ debugView: 'tone' }, 'views for checking'],
  [{ background: 'on' }, 'a hatched background'],
])('they lack something of %o', (changes, lack) => {
  expect(lackOf(changes)).toBe(lack);
  expect(lookOf({ ...defaultSettings(), ...changes }).lackOfNodes).toBe(lack);
});

test('what shadows would lack counts only where they are drawn', () => {
  const strokes = { shadowStrokes: 'cross' } as const;
  expect(lackOf(strokes)).toBeUndefined();
  expect(lackOf({ ...strokes, shadows: 'on' })).toBeDefined();
  expect(lackOf({ ground: 'shadow' })).toBeUndefined();
  expect(lackOf({ ground: 'shadow', shadows: 'on' })).toBeDefined();
});
