import { acceptSetting } from './acceptSetting.js';
import { SETTINGS, type Settings, settingsOf } from './settings.js';

/** The settings that a look of one's own sets: more than a preset does, shadows and what the model stands on among them. */
const LOOK_KEYS = settingsOf('hand', 'scene');

export type OwnLook = Partial<Settings>;

/**
 * A whole look by what is known of one: all settings, or what was stored. Values are those that the controls have, and unknown ones
 * their defaults. A map and a hand of the user's own stay with their drawing.
 */
export function acceptLook(known: Readonly<Record<string, unknown>>): OwnLook {
  const entries = LOOK_KEYS.map((key) => {
    const value = Object.hasOwn(known, key) ? known[key] : undefined;
    const isPlain = typeof value === 'string' || typeof value === 'number';
    const accepted = isPlain && value !== 'file' && value !== 'ownHand' ? acceptSetting(key, value) : undefined;
    return [key, accepted ?? SETTINGS[key].default];
  });
  return Object.fromEntries(entries);
}

/** Whether settings are those of a look. */
export const hasLook = (settings: Settings, look: OwnLook): boolean =>
  LOOK_KEYS.every((key) => settings[key] === look[key]);
