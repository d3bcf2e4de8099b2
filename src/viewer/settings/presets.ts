import { type PresetName, presets } from 'three-hatching';
import { settingsOfShadow } from './groundShadow.js';
import { settingsOfMaterial } from './materialLook.js';
import { settingsOfOutlines } from './outlineLook.js';
import { PRESET_NAMES } from './presetLabels.js';
import { defaultSettings, SETTINGS, type Settings, settingsOf } from './settings.js';

/** The settings that a preset sets. */
const LOOK_KEYS = settingsOf('hand', 'check');

/** The light that presets are made for: an intensity of π. */
const LIGHT_STRENGTH = 100;

/** All settings of a preset, also those at their default, so that nothing of the previous look remains. */
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

/** What the page adds to a preset's hand: shadows, on the model and below it, and dark hollows. */
const SHADED = { shadows: 'on', shadowStrokes: 'cross', ground: 'shadow', occlusion: 100 } as const;

/** Composition, which is the model's own again. */
const PLAIN = Object.fromEntries(
  settingsOf('scene')
    .filter((key) => SETTINGS[key].group === 'Composition')
    .map((key) => [key, SETTINGS[key].default]),
);

/**
 * What the button of a preset sets: its hand, and all else that makes the picture of a model under lights where they are. So it is
 * the same picture whatever was chosen before.
 */
export const wholeLook = (name: PresetName) => ({ ...presetLook(name), ...SHADED, ...PLAIN });

/** What the page shows at first, without a link: a print. */
export const firstView = (): Settings => ({ ...defaultSettings(), ...wholeLook('engraving') });
