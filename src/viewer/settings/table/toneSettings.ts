import { HATCHING_BACKGROUND_DEFAULTS } from 'three-hatching/facts';
import { PAGE_DEFAULTS } from './pageDefaults.js';
import {
  choiceOf,
  colorOf,
  inGroup,
  libraryDefault,
  type NumberRow,
  numberOf,
  percent,
  UNITS,
  type Unit,
} from './rows.js';

/** How light becomes tone. */
export const TONE_SETTINGS = inGroup('Tone', 'hand', {
  toneModel: choiceOf('toneModel', {
    label: 'Shading',
    choices: { lambert: 'Lambert', halfLambert: 'Half Lambert', phong: 'Phong', toon: 'Toon' },
  }),
  toneNormal: choiceOf('toneNormal', {
    label: 'Normals',
    choices: { auto: 'As the technique does', face: 'Of the triangles', smooth: 'Smoothed' },
  }),
  toneSteps: numberOf('toneSteps', { label: 'Toon steps', max: 8 }),
  shininess: numberOf('shininess', { label: 'Shininess', min: 1, max: 200 }),
  toneCurve: {
    kind: 'choice',
    label: 'Curve',
    partOf: 'toneCurve',
    default: PAGE_DEFAULTS.toneCurve,
    choices: {
      linear: 'As the light is',
      perceptual: 'As the eye sees it',
      contrast: 'More contrast',
      printed: 'As in prints',
      cut: 'As cut in wood',
      rubbed: 'As rubbed',
      chalked: 'As chalk on dark',
    },
  },
  blendAngle: numberOf('blendAngle', { label: 'Blend up to' }),
  highlightThreshold: numberOf('highlightThreshold', { label: 'Blank below', max: 60 }),
  colorHatching: numberOf('colorHatching', { label: 'Local tone', ends: ['white', 'by colour'] }),
});

/** Colours of ink, paper and surfaces. */
export const COLOUR_SETTINGS = inGroup('Colours', 'hand', {
  ink: colorOf('ink', { label: 'Ink' }),
  paper: colorOf('paper', { label: 'Paper' }),
  inkBlend: choiceOf('inkBlend', { label: 'On colour', choices: { cover: 'Ink covers', multiply: 'Ink tints' } }),
  surfaceColors: {
    kind: 'choice',
    label: 'Surfaces',
    owner: 'scene',
    default: 'shown',
    choices: { shown: 'By their own colours', paper: 'White as paper' },
  },
  colorFill: numberOf('colorFill', { label: 'Fill', ends: ['ink alone', 'coloured'] }),
  color: colorOf('color', { label: 'Model' }),
});

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

const strength = (label: string, fallback: number, added: Partial<NumberRow> = {}): NumberRow =>
  percent(label, fallback, { min: 10, max: 200, ...added });

const FREE = { secondLight: ['free'] } as const;
const SPOT = { lightKind: ['spot'] } as const;
const SHADOWED = { shadows: ['on'] } as const;
const ON_SHADOW = { ...SHADOWED, ground: ['shadow'] } as const;

/**
 * The row of a property of the ground's shadow, in percent. It is none of the material settings, since the ground's material has it and
 * not the model's.
 */
const onGround = (
  property: 'shadowTone' | 'shadowFade' | 'shadowSoftness',
  label: string,
  added: Partial<NumberRow>,
): NumberRow =>
  percent(label, UNITS.share.toSetting(Number(libraryDefault(property))), { owner: 'hand', when: ON_SHADOW, ...added });

/** The lights and their shadows. */
export const LIGHT_SETTINGS = inGroup('Light', 'subject', {
  exposure: {
    kind: 'choice',
    label: 'Exposure',
    owner: 'hand',
    partOf: 'exposure',
    default: PAGE_DEFAULTS.exposure,
    choices: { auto: 'Fitted to the model', fixed: 'As the lights are' },
  },
  lightStrength: strength('Strength', PAGE_DEFAULTS.lightStrength, { owner: 'hand' }),
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
  spotSoftness: percent('Spot softness', 30, { when: SPOT }),
  reflectedLight: numberOf('reflectedLight', { label: 'Reflected', owner: 'hand', max: 60 }),
  occlusion: numberOf('occlusion', { label: 'Dark hollows', owner: 'scene', step: 5 }),
  hollowStrength: numberOf('hollowStrength', {
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
  shadowTone: onGround('shadowTone', 'Shadow tone', { min: 10 }),
  shadowFade: onGround('shadowFade', 'Shadow dissolves', { max: 300, step: 5, ends: ['nowhere', 'near the model'] }),
  shadowSoftness: onGround('shadowSoftness', 'Shadow softens', { max: 50, ends: ['nowhere', 'at once'] }),
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

const FADING = { depth: ['on'] } as const;
const FOCUSED = { focus: ['on'] } as const;

/** The row of a number of `HatchingBackground`. */
const behind = (
  property: 'tone' | 'spacing' | 'direction' | 'extent',
  { name, step, toSetting }: Unit,
  added: Pick<NumberRow, 'label' | 'min' | 'max'> & { step?: number },
): NumberRow => ({
  kind: 'number',
  when: { background: ['on'] },
  default: toSetting(HATCHING_BACKGROUND_DEFAULTS[property]),
  unit: name,
  step,
  ...added,
});

/** A slider for one coordinate of the focus, relative to the middle of the model. */
const coordinate = (label: string, fallback: number): NumberRow & { owner: 'subject' } => ({
  kind: 'number',
  label,
  owner: 'subject',
  partOf: 'focus',
  when: FOCUSED,
  default: fallback,
  unit: 'radii',
  min: -1.5,
  max: 1.5,
  step: 0.01,
});

/** Where the drawing fades. */
export const COMPOSITION_SETTINGS = inGroup('Composition', 'scene', {
  depth: {
    kind: 'choice',
    label: 'Distance',
    partOf: 'depthFade',
    default: String(libraryDefault('depthFade')),
    choices: { auto: 'Fades in deep scenes', on: 'Fades', off: 'Does not fade' },
  },
  depthStrength: percent('Fades by', 70, { partOf: 'depthFade', when: FADING }),
  depthFadeStart: numberOf('depthFadeStart', {
    label: 'From',
    when: FADING,
    min: 0,
    max: 100,
    ends: ['front', 'back'],
  }),
  depthFadeEnd: numberOf('depthFadeEnd', { label: 'Up to', when: FADING, min: 0, max: 200, ends: ['front', 'beyond'] }),
  focus: {
    kind: 'choice',
    label: 'Focus',
    owner: 'subject',
    partOf: 'focus',
    default: 'none',
    choices: { none: 'Everywhere', on: 'On a place' },
  },
  focusX: coordinate('Focus, x', 0),
  focusY: coordinate('Focus, y', 0.2),
  focusZ: coordinate('Focus, z', 0.4),
  focusRadius: numberOf('focusRadius', {
    label: 'Focus, radius',
    owner: 'subject',
    when: FOCUSED,
    min: 0.05,
    max: 2,
  }),
  vignette: numberOf('vignette', { label: 'Vignette', step: 5, ends: ['none', 'blank rim'] }),
  background: {
    kind: 'choice',
    label: 'Background',
    default: 'none',
    choices: { none: 'None', on: 'Hatched' },
  },
  backgroundTone: behind('tone', UNITS.share, { label: 'Background tone', min: 0, max: 60 }),
  backgroundSpacing: behind('spacing', UNITS.pixels, { label: 'Background spacing', min: 2, max: 20 }),
  backgroundDirection: behind('direction', UNITS.radians, { label: 'Background direction', min: -90, max: 90 }),
  backgroundExtent: behind('extent', UNITS.share, { label: 'Background reach', min: 100, max: 300, step: 5 }),
});
