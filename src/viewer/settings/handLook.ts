import { engravedHand, type Hand } from 'three-hatching';
import { acceptSetting } from './acceptSetting.js';
import { settingsOfMaterial } from './materialLook.js';
import { SETTINGS, type SettingKey, type Settings } from './settings.js';
import { drawsWithMap } from './settingValues.js';

/** The settings that show a hand of the user's own. Lines are drawn without a map, so that the technique becomes one that has strokes. */
export function handLook(settings: Settings, hand: Hand): Partial<Settings> {
  const look = { ...linesOfHand(settings, hand), mapStyle: 'ownHand' } as const;
  if (drawsWithMap({ ...settings, ...look })) return look;
  return { ...look, technique: 'anchored', medium: SETTINGS.medium.default };
}

/** The settings by which engraved lines and outlines come from the same hand, within the ranges of their controls. */
export function linesOfHand(settings: Settings, hand: Hand): Partial<Settings> {
  const { material, outlines } = engravedHand(hand, settings);
  const lines: Partial<Settings> = {
    ...settingsOfMaterial(material),
    outlineHand: outlines.wobble,
    outlineAccents: 100 * outlines.accents,
  };
  const entries = Object.entries(lines).map(([key, value]) => [key, acceptSetting(key as SettingKey, value)]);
  return Object.fromEntries(entries.filter(([, value]) => value !== undefined));
}

/** The settings once there is no hand any more. */
export const lookWithoutHand = ({ mapStyle }: Settings): Partial<Settings> =>
  mapStyle === 'ownHand' ? { mapStyle: SETTINGS.mapStyle.default } : {};
