import { expect, test } from 'vitest';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { drawSwatches } from '../../../../src/strokes/hands/drawSwatch.js';
import { exampleHabits, type PenHabits } from '../../../../src/strokes/hands/exampleHabits.js';
import { handLook, linesOfHand, lookWithoutHand } from '../../../../src/viewer/settings/handLook.js';
import { firstView } from '../../../../src/viewer/settings/presets.js';
import { acceptSetting, defaultSettings, type SettingKey } from '../../../../src/viewer/settings/settings.js';
import { drawsWithMap } from '../../../../src/viewer/settings/settingValues.js';

const learnt = (habits: PenHabits) => learnHand(drawSwatches(habits, 1));
const hands = Object.values(exampleHabits).map(learnt);

test('a hand is drawn with a map, also where there were lines before; a technique with strokes stays', () => {
  const engraved = { ...firstView(), ...handLook(firstView(), hands[0]) };
  expect([engraved.technique, engraved.mapStyle, drawsWithMap(engraved)]).toEqual(['hatching', 'ownHand', true]);
  const settings = { ...defaultSettings(), technique: 'triangle' } as const;
  expect({ ...settings, ...handLook(settings, hands[0]) }.technique).toBe('triangle');
  expect({ ...engraved, ...lookWithoutHand(engraved) }.mapStyle).toBe('hatching');
  expect(lookWithoutHand({ ...settings, mapStyle: 'ruled' })).toEqual({});
});

test('lines follow the hand, within the ranges of their controls: a felt tip is steadier than a scribble', () => {
  const [scribble, felt] = [exampleHabits.scribble, exampleHabits.feltTip].map((habits) =>
    linesOfHand(defaultSettings(), learnt(habits)),
  );
  expect(felt.irregularity).toBeLessThan(scribble.irregularity!);
  expect(felt.outlineHand).toBeLessThanOrEqual(scribble.outlineHand!);
  for (const hand of hands) {
    for (const [key, value] of Object.entries(linesOfHand(defaultSettings(), hand))) {
      expect(acceptSetting(key as SettingKey, value), key).toBe(value);
    }
  }
});
