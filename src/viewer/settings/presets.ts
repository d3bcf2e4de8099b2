import { type PresetName, presets } from 'three-hatching';
import { settingsOfShadow } from './groundShadow.js';
import { settingsOfMaterial } from './materialLook.js';
import { settingsOfOutlines } from './outlineLook.js';
import { PRESET_NAMES } from './presetLabels.js';
import { defaultSettings, SETTINGS, type Settings, settingsOf } from './settings.js';

/** The settings that belong to a preset. */
const LOOK_KEYS = settingsOf('hand', 'check');

/** The light strength that presets are designed for, in percent: an intensity of π. */
const LIGHT_STRENGTH = 100;

/** All settings of a preset, including defaults, so that nothing of the previous look remains. */
export function presetLook(name: PresetName): Partial<Settings> {
  const { material, outlines, tonalArtMap } = presets[name];
  return {
    ...Object.fromEntries(LOOK_KEYS.map((key) => [key, SETTINGS[key].default])),
    lightStrength: LIGHT_STRENGTH,
    ...settingsOfMaterial(material),
    ...settingsOfShadow(material),
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
