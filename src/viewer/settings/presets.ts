import { type PresetName, presets } from 'three-hatching';
import { settingsOfMaterial, settingsOfOutlines, settingsOfShadow } from './materialLook.js';
import { PRESET_NAMES } from './presetLabels.js';
import { acceptSetting, defaultSettings, SETTINGS, type Settings, settingsOf } from './settings.js';

/** The settings that belong to a preset. */
const LOOK_KEYS = settingsOf('hand', 'check');

/** The light strength that presets are designed for, in percent: an intensity of π. */
const LIGHT_STRENGTH = 100;

/** All settings of a preset, including defaults, so that nothing of the previous look remains. */
export function presetLook(name: PresetName): Partial<Settings> {
  const { material, outlines, shadow, tonalArtMap } = presets[name];
  return {
    ...Object.fromEntries(LOOK_KEYS.map((key) => [key, SETTINGS[key].default])),
    lightStrength: LIGHT_STRENGTH,
    ...settingsOfMaterial(material),
    ...settingsOfShadow(shadow),
    ...settingsOfOutlines(outlines),
    ...(tonalArtMap?.style && { mapStyle: tonalArtMap.style }),
  };
}

/** The preset that the settings match, or undefined. */
export function presetOf(settings: Settings): PresetName | undefined {
  return PRESET_NAMES.find((name) => {
    const look = presetLook(name);
    return LOOK_KEYS.every((key) => settings[key] === look[key]);
  });
}

/** Settings that the page adds to a preset: cast shadows, on the model and on the ground, and dark hollows. */
const SHADED = { shadows: 'on', shadowStrokes: 'cross', ground: 'shadow', occlusion: 100 } as const;

/** Default composition. */
const PLAIN = Object.fromEntries(
  settingsOf('scene')
    .filter((key) => SETTINGS[key].group === 'Composition')
    .map((key) => [key, SETTINGS[key].default]),
);

/**
 * The settings of a preset's button: the preset, the page's shadows, and default composition. The lights stay where they are. The result
 * does not depend on the previous settings.
 */
export const wholeLook = (name: PresetName) => ({ ...presetLook(name), ...SHADED, ...PLAIN });

/** The page's settings without a link: an engraving. */
export const firstView = (): Settings => ({ ...defaultSettings(), ...wholeLook('engraving') });

/** The settings that a user's saved look contains: those of a preset, plus shadows and the ground. */
const SAVED_KEYS = settingsOf('hand', 'scene');

export type OwnLook = Partial<Settings>;

/**
 * A complete look from all settings, or from stored ones. Invalid or missing values become defaults. The user's own map and hand are not
 * part of a look.
 */
export function acceptLook(known: Readonly<Record<string, unknown>>): OwnLook {
  const entries = SAVED_KEYS.map((key) => {
    const value = Object.hasOwn(known, key) ? known[key] : undefined;
    const isPlain = typeof value === 'string' || typeof value === 'number';
    const accepted = isPlain && value !== 'file' && value !== 'ownHand' ? acceptSetting(key, value) : undefined;
    return [key, accepted ?? SETTINGS[key].default];
  });
  return Object.fromEntries(entries);
}

/** Whether settings match a look. */
export const hasLook = (settings: Settings, look: OwnLook): boolean =>
  SAVED_KEYS.every((key) => settings[key] === look[key]);

/** Lighting presets that illustrators use, by label. The lights move with the viewer. */
export const LIGHT_LOOKS: Readonly<Record<string, Partial<Settings>>> = {
  'From the upper left, as in plates': lookOf(-45, 45),
  'Raking from the side': lookOf(-78, 12),
  'From behind': lookOf(-150, 35),
  'From below': lookOf(-20, -50),
  'From two sides': { ...lookOf(-55, 30), secondLight: 'right', secondStrength: 60 },
};

function lookOf(lightAzimuth: number, lightElevation: number): Partial<Settings> {
  return { lightFollows: 'viewer', lightAzimuth, lightElevation, secondLight: 'none' };
}
