import { choiceOf, numberOf } from './materialRows.js';
import { inGroup, type NumberRow } from './Setting.js';

/** A slider for an azimuth or an elevation, in degrees. */
const degrees = (label: string, fallback: number, most: number, added: Partial<NumberRow> = {}): NumberRow => ({
  kind: 'number',
  label,
  default: fallback,
  unit: '°',
  min: -most,
  max: most,
  step: 0.1,
  ...added,
});

const strength = (label: string, fallback: number, added: Partial<NumberRow> = {}): NumberRow => ({
  kind: 'number',
  label,
  default: fallback,
  unit: '%',
  min: 10,
  max: 200,
  step: 1,
  ...added,
});

const FREE = { secondLight: ['free'] } as const;
const SPOT = { lightKind: ['spot'] } as const;
const SHADOWED = { shadows: ['on'] } as const;
const ON_SHADOW = { ...SHADOWED, ground: ['shadow'] } as const;

/** The lights and their shadows. */
export const LIGHT_SETTINGS = inGroup('Light', 'subject', {
  exposure: {
    kind: 'choice',
    label: 'Exposure',
    owner: 'hand',
    partOf: 'exposure',
    default: 'auto',
    choices: { auto: 'Fitted to the model', fixed: 'As the lights are' },
  },
  lightStrength: strength('Strength', 115, { owner: 'hand' }),
  lightAzimuth: degrees('Around', -54, 180),
  lightElevation: degrees('Height', 38, 89),
  lightFollows: {
    kind: 'choice',
    label: 'Stays with',
    default: 'model',
    choices: { model: 'The model', viewer: 'The viewer' },
  },
  lightDistance: {
    kind: 'number',
    label: 'Distance',
    when: { lightKind: ['point', 'spot'] },
    default: 1.8,
    unit: 'radii',
    min: 1.1,
    max: 5,
    step: 0.01,
  },
  spotAngle: {
    kind: 'number',
    label: 'Spot width',
    when: SPOT,
    default: 52,
    unit: '°',
    min: 5,
    max: 120,
    step: 1,
  },
  spotSoftness: {
    kind: 'number',
    label: 'Spot softness',
    when: SPOT,
    default: 30,
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  reflectedLight: numberOf('reflectedLight', { label: 'Reflected', owner: 'hand', default: 43, max: 60 }),
  occlusion: numberOf('occlusion', { label: 'Dark hollows', owner: 'scene', default: 0, step: 5 }),
  hollowTone: numberOf('hollowTone', {
    label: 'Their depths',
    owner: 'hand',
    ends: ['as lit', 'darkest'],
  }),
  shadows: {
    kind: 'choice',
    label: 'Shadows',
    owner: 'scene',
    default: 'off',
    choices: { on: 'Drawn', off: 'None' },
  },
  shadowStrokes: choiceOf('shadowStrokes', {
    label: 'Shadow strokes',
    owner: 'scene',
    when: SHADOWED,
    choices: { tone: 'Darken strokes', cross: 'Cross strokes', reorient: 'Turn strokes' },
  }),
  ground: {
    kind: 'choice',
    label: 'Stands on',
    owner: 'scene',
    when: SHADOWED,
    default: 'none',
    choices: { none: 'Nothing', shadow: 'Its shadow', floor: 'A floor' },
  },
  shadowTone: {
    kind: 'number',
    label: 'Shadow tone',
    owner: 'hand',
    when: ON_SHADOW,
    default: 50,
    unit: '%',
    min: 10,
    max: 100,
    step: 1,
  },
  shadowFade: {
    kind: 'number',
    label: 'Shadow dissolves',
    owner: 'hand',
    when: ON_SHADOW,
    default: 65,
    unit: '%',
    min: 0,
    max: 300,
    step: 5,
    ends: ['nowhere', 'near the model'],
  },
  shadowSoftness: {
    kind: 'number',
    label: 'Shadow softens',
    owner: 'hand',
    when: ON_SHADOW,
    default: 12,
    unit: '%',
    min: 0,
    max: 50,
    step: 1,
    ends: ['nowhere', 'at once'],
  },
  secondLight: {
    kind: 'choice',
    label: 'Second sun',
    default: 'none',
    choices: {
      none: 'None',
      left: 'Left of the light',
      right: 'Right of the light',
      opposite: 'Opposite',
      free: 'Where you drag it',
    },
  },
  secondAzimuth: degrees('Its place around', 60, 180, { when: FREE }),
  secondElevation: degrees('Its height', 20, 89, { when: FREE }),
  secondStrength: strength('Its strength', 35, { when: { secondLight: ['left', 'right', 'opposite', 'free'] } }),
});
