import { type Hand, handLines } from 'three-hatching';
import { settingsOfMaterial } from './materialLook.js';
import { acceptSetting, SETTINGS, type SettingKey, type Settings } from './settings.js';
import { drawsWithMap } from './settingValues.js';

/**
 * Settings that draw with the user's own hand. If the technique draws lines without a tonal art map, it changes to one that draws with
 * strokes.
 */
export function handLook(settings: Settings, hand: Hand): Partial<Settings> {
  const look = { ...linesOfHand(settings, hand), mapStyle: 'ownHand' } as const;
  if (drawsWithMap({ ...settings, ...look })) return look;
  return { ...look, technique: SETTINGS.technique.default };
}

/** Settings that make lines and outlines match the hand, within the ranges of their controls. */
export function linesOfHand(settings: Settings, hand: Hand): Partial<Settings> {
  const { material, outlines } = handLines(hand, settings);
  const lines: Partial<Settings> = {
    ...settingsOfMaterial(material),
    outlineHand: outlines.wobble,
    outlineAccents: 100 * outlines.accents,
  };
  const entries = Object.entries(lines).map(([key, value]) => [key, acceptSetting(key as SettingKey, value)]);
  return Object.fromEntries(entries.filter(([, value]) => value !== undefined));
}

/** Settings for when the user's own hand is removed. */
export const lookWithoutHand = ({ mapStyle }: Settings): Partial<Settings> =>
  mapStyle === 'ownHand' ? { mapStyle: SETTINGS.mapStyle.default } : {};
