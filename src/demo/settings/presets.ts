import { SETTINGS, type SettingKey, type Settings } from './settings.js';

/** What makes a hand: everything but the model, the light, the view and where the picture goes. */
const LOOK_KEYS = [
  'technique',
  'mapStyle',
  'mapSize',
  'mapTones',
  'mapSeed',
  'screenConstancy',
  'strokeWidth',
  'strokeScale',
  'strokeDirection',
  'strokeAngle',
  'anchorSpacing',
  'edge',
  'offsetU',
  'offsetV',
  'toneModel',
  'toneNormal',
  'toneSteps',
  'shininess',
  'toneCurve',
  'reflectedLight',
  'lightStrength',
  'inkBlend',
  'levelRule',
  'ink',
  'paper',
  'color',
  'debugView',
] as const satisfies readonly SettingKey[];

type Look = Pick<Settings, (typeof LOOK_KEYS)[number]>;

export interface Preset {
  label: string;
  /** Where it differs from the defaults. */
  look: Partial<Look>;
}

export const PRESETS = {
  pen: { label: 'Pen', look: {} },
  woodcut: {
    label: 'Woodcut',
    look: {
      mapStyle: 'woodcut',
      strokeWidth: 3.5,
      strokeScale: 1.2,
      anchorSpacing: 0.6,
      strokeDirection: 'along',
      lightStrength: 130,
      reflectedLight: 19,
      ink: '#120e0a',
      paper: '#ece0c4',
    },
  },
  stipple: {
    label: 'Stipple',
    look: { mapStyle: 'stippling', screenConstancy: 100, strokeWidth: 1.8, lightStrength: 125, reflectedLight: 36 },
  },
  pencil: {
    label: 'Pencil',
    look: {
      mapStyle: 'pencil',
      strokeWidth: 1.4,
      strokeScale: 2,
      edge: 2,
      lightStrength: 120,
      reflectedLight: 46,
      ink: '#4b4a50',
      paper: '#fbfaf6',
    },
  },
  charcoal: {
    label: 'Charcoal',
    look: {
      mapStyle: 'charcoal',
      strokeWidth: 2,
      strokeScale: 2.2,
      reflectedLight: 30,
      ink: '#24211f',
      paper: '#efe9dc',
    },
  },
} as const satisfies Record<string, Preset>;

export type PresetName = keyof typeof PRESETS;

/** The look a preset gives: every setting of it, so that nothing of the look before stays. */
export function presetLook(name: PresetName): Look {
  const defaults = Object.fromEntries(LOOK_KEYS.map((key) => [key, SETTINGS[key].default])) as Look;
  return { ...defaults, ...PRESETS[name].look };
}

/** The preset that settings are of, or undefined when something was changed since. */
export function presetOf(settings: Settings): PresetName | undefined {
  return (Object.keys(PRESETS) as PresetName[]).find((name) => {
    const look = presetLook(name);
    return LOOK_KEYS.every((key) => settings[key] === look[key]);
  });
}
