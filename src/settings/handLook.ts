import { SETTINGS, type Settings } from './settings.js';
import { drawsWithMap } from './settingValues.js';

/** The settings that show a hand of the user's own. Lines are drawn without a map, so that the technique becomes one that has strokes. */
export function handLook(settings: Settings): Partial<Settings> {
  const look = { mapStyle: 'ownHand' } as const;
  if (drawsWithMap({ ...settings, ...look })) return look;
  return { ...look, technique: 'anchored', medium: SETTINGS.medium.default };
}

/** The settings once there is no hand any more. */
export const lookWithoutHand = ({ mapStyle }: Settings): Partial<Settings> =>
  mapStyle === 'ownHand' ? { mapStyle: SETTINGS.mapStyle.default } : {};
