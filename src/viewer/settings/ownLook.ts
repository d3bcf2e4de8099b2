import { acceptSetting } from './acceptSetting.js';
import { SETTINGS, type Settings, settingsOf } from './settings.js';

/** The settings that a user's saved look contains: those of a preset, plus shadows and the ground. */
const LOOK_KEYS = settingsOf('hand', 'scene');

export type OwnLook = Partial<Settings>;

/**
 * A complete look from all settings, or from stored ones. Invalid or missing values become defaults. The user's own map and hand are not
 * part of a look.
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

/** Whether settings match a look. */
export const hasLook = (settings: Settings, look: OwnLook): boolean =>
  LOOK_KEYS.every((key) => settings[key] === look[key]);
