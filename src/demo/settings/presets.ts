import { SETTINGS, type SettingKey, type Settings } from './settings.js';

/** The settings that a preset sets: all but the model, the light, the view and the export, and whether there are lines. */
const LOOK_KEYS = [
  'technique',
  'mapStyle',
  'mapSize',
  'mapTones',
  'mapSeed',
  'screenConstancy',
  'strokeWidth',
  'strokeScale',
  'lineField',
  'lineSpacing',
  'crossFrom',
  'handmade',
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
  'lineWidth',
  'lineContours',
  'lineBorders',
  'lineCreases',
  'lineSuggestive',
  'lineShade',
  'lineHand',
  'ink',
  'paper',
  'color',
  'debugView',
] as const satisfies readonly SettingKey[];

type Look = Pick<Settings, (typeof LOOK_KEYS)[number]>;

export interface Preset {
  label: string;
  /** Its differences from the defaults. */
  look: Partial<Look>;
}

export const PRESETS = {
  pen: { label: 'Pen', look: {} },
  engraving: {
    label: 'Engraving',
    look: {
      technique: 'engraved',
      screenConstancy: 100,
      lightStrength: 125,
      reflectedLight: 16,
      lineWidth: 1.6,
      lineHand: 0,
    },
  },
  woodcut: {
    label: 'Woodcut',
    look: {
      mapStyle: 'woodcut',
      strokeWidth: 4.4,
      strokeScale: 1.2,
      anchorSpacing: 0.6,
      strokeDirection: 'along',
      lightStrength: 130,
      reflectedLight: 19,
      lineWidth: 3,
      lineHand: 0,
      ink: '#120e0a',
      paper: '#ece0c4',
    },
  },
  stipple: {
    label: 'Stipple',
    look: {
      mapStyle: 'stippling',
      screenConstancy: 100,
      strokeWidth: 2.2,
      lightStrength: 125,
      reflectedLight: 36,
      lineWidth: 1,
      lineShade: 30,
    },
  },
  pencil: {
    label: 'Pencil',
    look: {
      mapStyle: 'pencil',
      strokeWidth: 1.3,
      strokeScale: 2,
      edge: 2,
      lightStrength: 120,
      reflectedLight: 46,
      lineWidth: 1.5,
      lineHand: 1,
      ink: '#4b4a50',
      paper: '#fbfaf6',
    },
  },
  charcoal: {
    label: 'Charcoal',
    look: {
      mapStyle: 'charcoal',
      strokeWidth: 2.6,
      strokeScale: 2.2,
      reflectedLight: 30,
      lineWidth: 3,
      lineHand: 1,
      ink: '#24211f',
      paper: '#efe9dc',
    },
  },
} as const satisfies Record<string, Preset>;

export type PresetName = keyof typeof PRESETS;

/** All settings of a preset, also those at their default, so that nothing of the previous look remains. */
export function presetLook(name: PresetName): Look {
  const defaults = Object.fromEntries(LOOK_KEYS.map((key) => [key, SETTINGS[key].default])) as Look;
  return { ...defaults, ...PRESETS[name].look };
}

/** The preset that the settings match, or undefined. */
export function presetOf(settings: Settings): PresetName | undefined {
  return (Object.keys(PRESETS) as PresetName[]).find((name) => {
    const look = presetLook(name);
    return LOOK_KEYS.every((key) => settings[key] === look[key]);
  });
}
