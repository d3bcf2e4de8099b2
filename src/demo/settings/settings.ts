/** Everything a person can set, as plain data in one place: the panel, the link and the drawing all read this table. */
import type { BuiltInModel } from '../models/models.js';

interface SettingBase<Value> {
  label: string;
  default: Value;
  group: SettingGroup;
}

export interface NumberSetting extends SettingBase<number> {
  kind: 'number';
  unit: string;
  min: number;
  max: number;
  step: number;
  /** What the least and the greatest value mean, in a word or two each, where the number alone does not say it. */
  ends?: readonly [least: string, greatest: string];
}

export interface ChoiceSetting extends SettingBase<string> {
  kind: 'choice';
  /** Value to the words shown for it. */
  choices: Readonly<Record<string, string>>;
}

export interface ColorSetting extends SettingBase<string> {
  kind: 'color';
}

export type Setting = NumberSetting | ChoiceSetting | ColorSetting;

/** Groups of the panel in their order; the first stands open, the others are folded. */
export const SETTING_GROUPS = ['Drawing', 'Strokes', 'Tone', 'Colours', 'Light', 'View', 'Picture'] as const;
export type SettingGroup = (typeof SETTING_GROUPS)[number];

const TECHNIQUES = {
  anchored: 'Anchored',
  adjacency: 'Adjacency',
  adjacencyCrisp: 'Adjacency, crisp',
  triangle: 'Per triangle',
} as const;

export const SETTINGS = {
  model: {
    kind: 'choice',
    label: 'Model',
    group: 'Drawing',
    default: 'dragon3',
    choices: {
      dragon4: 'Dragon, 11 thousand',
      dragon3: 'Dragon, 48 thousand',
      dragon2: 'Dragon, 202 thousand',
      dragon1: 'Dragon, 871 thousand',
      bunny: 'Bunny',
      suzanne: 'Suzanne',
      teapot: 'Teapot',
      fish: 'Fish, swimming',
      cube: 'Cube',
      sphere: 'Sphere',
      file: 'Your own',
    } satisfies Record<BuiltInModel | 'file', string>,
  },
  technique: { kind: 'choice', label: 'Technique', group: 'Drawing', default: 'anchored', choices: TECHNIQUES },
  compare: {
    kind: 'choice',
    label: 'Compare with',
    group: 'Drawing',
    default: 'none',
    choices: { none: 'Nothing', ...TECHNIQUES },
  },
  mapStyle: {
    kind: 'choice',
    label: 'Style',
    group: 'Drawing',
    default: 'hatching',
    choices: {
      hatching: 'Hatching',
      crossHatching: 'Cross-hatching',
      tripleHatching: 'Three layers',
      ruled: 'Ruled lines',
      contours: 'Long lines',
      dashes: 'Dashes',
      stippling: 'Stippling',
      pencil: 'Pencil',
      charcoal: 'Charcoal',
      woodcut: 'Woodcut',
      file: 'Your own',
    },
  },
  screenConstancy: {
    kind: 'number',
    label: 'Stroke size',
    group: 'Drawing',
    default: 0,
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
    ends: ['on the object', 'on the screen'],
  },
  strokeWidth: {
    kind: 'number',
    label: 'Stroke width',
    group: 'Drawing',
    default: 1.6,
    unit: 'px',
    min: 0.5,
    max: 8,
    step: 0.1,
  },
  strokeScale: {
    kind: 'number',
    label: 'Stroke scale',
    group: 'Drawing',
    default: 2.5,
    unit: 'tiles',
    min: 0.5,
    max: 8,
    step: 0.1,
  },
  strokeDirection: {
    kind: 'choice',
    label: 'Direction',
    group: 'Drawing',
    default: 'towards',
    choices: { along: 'Around the light', towards: 'Towards the light', angle: 'At an angle' },
  },
  lightKind: {
    kind: 'choice',
    label: 'Light',
    group: 'Drawing',
    default: 'directional',
    choices: { directional: 'Sun', point: 'Lamp', spot: 'Spot' },
  },
  lightStrength: {
    kind: 'number',
    label: 'Strength',
    group: 'Drawing',
    default: 115,
    unit: '%',
    min: 10,
    max: 200,
    step: 1,
  },

  strokeAngle: {
    kind: 'number',
    label: 'Angle',
    group: 'Strokes',
    default: 45,
    unit: '°',
    min: 0,
    max: 180,
    step: 1,
  },
  anchorSpacing: {
    kind: 'number',
    label: 'Anchors',
    group: 'Strokes',
    default: 0.4,
    unit: 'tiles',
    min: 0.1,
    max: 1,
    step: 0.01,
  },
  edge: { kind: 'number', label: 'Soft edge', group: 'Strokes', default: 1, unit: 'px', min: 0, max: 4, step: 0.1 },
  offsetU: {
    kind: 'number',
    label: 'Shift along',
    group: 'Strokes',
    default: 0,
    unit: 'tiles',
    min: 0,
    max: 1,
    step: 0.01,
  },
  offsetV: {
    kind: 'number',
    label: 'Shift across',
    group: 'Strokes',
    default: 0,
    unit: 'tiles',
    min: 0,
    max: 1,
    step: 0.01,
  },
  levelRule: {
    kind: 'choice',
    label: 'Levels',
    group: 'Strokes',
    default: 'derivatives',
    choices: { derivatives: 'By depth and slant', depth: 'By depth alone' },
  },
  mapTones: { kind: 'number', label: 'Tones', group: 'Strokes', default: 8, unit: '', min: 4, max: 16, step: 1 },
  mapSize: {
    kind: 'choice',
    label: 'Tile size',
    group: 'Strokes',
    default: '256',
    choices: { 64: '64 px', 128: '128 px', 256: '256 px', 512: '512 px' },
  },
  mapSeed: { kind: 'number', label: 'Seed', group: 'Strokes', default: 1, unit: '', min: 1, max: 99, step: 1 },

  toneModel: {
    kind: 'choice',
    label: 'Shading',
    group: 'Tone',
    default: 'lambert',
    choices: { lambert: 'Lambert', halfLambert: 'Half Lambert', phong: 'Phong', toon: 'Toon' },
  },
  toneNormal: {
    kind: 'choice',
    label: 'Normals',
    group: 'Tone',
    default: 'auto',
    choices: { auto: 'As the technique does', face: 'Of the triangles', smooth: 'Smoothed' },
  },
  toneSteps: { kind: 'number', label: 'Toon steps', group: 'Tone', default: 4, unit: '', min: 2, max: 8, step: 1 },
  shininess: { kind: 'number', label: 'Shininess', group: 'Tone', default: 30, unit: '', min: 1, max: 200, step: 1 },
  toneCurve: {
    kind: 'choice',
    label: 'Curve',
    group: 'Tone',
    default: 'linear',
    choices: { linear: 'As the light is', perceptual: 'As the eye sees it', contrast: 'More contrast' },
  },
  creaseAngle: {
    kind: 'number',
    label: 'Crease from',
    group: 'Tone',
    default: 90,
    unit: '°',
    min: 0,
    max: 180,
    step: 1,
  },

  ink: { kind: 'color', label: 'Ink', group: 'Colours', default: '#1c1a17' },
  paper: { kind: 'color', label: 'Paper', group: 'Colours', default: '#f7f3e8' },
  inkBlend: {
    kind: 'choice',
    label: 'On colour',
    group: 'Colours',
    default: 'cover',
    choices: { cover: 'Ink covers', multiply: 'Ink tints' },
  },
  surfaceColors: {
    kind: 'choice',
    label: 'Surfaces',
    group: 'Colours',
    default: 'shown',
    choices: { shown: 'In their own colours', paper: 'White as paper' },
  },
  color: { kind: 'color', label: 'Model', group: 'Colours', default: '#ffffff' },

  lightAzimuth: {
    kind: 'number',
    label: 'Around',
    group: 'Light',
    default: -54,
    unit: '°',
    min: -180,
    max: 180,
    step: 1,
  },
  lightElevation: {
    kind: 'number',
    label: 'Height',
    group: 'Light',
    default: 38,
    unit: '°',
    min: -89,
    max: 89,
    step: 1,
  },
  lightDistance: {
    kind: 'number',
    label: 'Distance',
    group: 'Light',
    default: 1.8,
    unit: 'radii',
    min: 1.1,
    max: 5,
    step: 0.05,
  },
  spotAngle: { kind: 'number', label: 'Spot width', group: 'Light', default: 52, unit: '°', min: 5, max: 120, step: 1 },
  spotSoftness: {
    kind: 'number',
    label: 'Spot softness',
    group: 'Light',
    default: 30,
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  reflectedLight: {
    kind: 'number',
    label: 'Reflected',
    group: 'Light',
    default: 43,
    unit: '%',
    min: 0,
    max: 60,
    step: 1,
  },
  secondLight: {
    kind: 'choice',
    label: 'Second sun',
    group: 'Light',
    default: 'none',
    choices: { none: 'None', left: 'Left of the light', right: 'Right of the light', opposite: 'Opposite' },
  },
  secondStrength: {
    kind: 'number',
    label: 'Its strength',
    group: 'Light',
    default: 35,
    unit: '%',
    min: 10,
    max: 200,
    step: 1,
  },
  strokeLayers: {
    kind: 'choice',
    label: 'Layers',
    group: 'Light',
    default: '2',
    choices: { 1: 'One', 2: 'Two, where lights cross' },
  },

  upAxis: {
    kind: 'choice',
    label: 'Upright axis',
    group: 'View',
    default: 'y',
    choices: { y: 'Y', z: 'Z' },
  },
  debugView: {
    kind: 'choice',
    label: 'Show',
    group: 'View',
    default: 'none',
    choices: { none: 'The drawing', blendFactors: 'Blend factors', tone: 'Tone', frames: 'Frames' },
  },

  pictureSize: {
    kind: 'choice',
    label: 'Size',
    group: 'Picture',
    default: '1',
    choices: { 1: 'As on the page', 2: 'Twice the page', 4: 'Four times the page' },
  },
  pictureGround: {
    kind: 'choice',
    label: 'Ground',
    group: 'Picture',
    default: 'paper',
    choices: { paper: 'Paper', transparent: 'Transparent', strokes: 'Transparent, strokes alone' },
  },
} as const satisfies Record<string, Setting>;

export type SettingKey = keyof typeof SETTINGS;

/** The values: a number for a number setting, one of the choices for a choice, `#rrggbb` for a colour. */
export type Settings = {
  [Key in SettingKey]: (typeof SETTINGS)[Key] extends NumberSetting
    ? number
    : (typeof SETTINGS)[Key] extends { choices: infer Choices }
      ? `${Extract<keyof Choices, string | number>}`
      : string;
};

export const SETTING_KEYS = Object.keys(SETTINGS) as SettingKey[];

/** A fresh object with every setting at its default. */
export function defaultSettings(): Settings {
  return Object.fromEntries(SETTING_KEYS.map((key) => [key, SETTINGS[key].default])) as Settings;
}

/** The value nearest to `value` that a setting allows, or undefined when there is none. */
export function acceptSetting(key: SettingKey, value: string | number): string | number | undefined {
  const setting: Setting = SETTINGS[key];
  switch (setting.kind) {
    case 'number': {
      const number = Number(value);
      if (value === '' || !Number.isFinite(number)) return undefined;
      return Math.min(setting.max, Math.max(setting.min, number));
    }
    case 'choice':
      return Object.hasOwn(setting.choices, value) ? String(value) : undefined;
    case 'color':
      return /^#[0-9a-f]{6}$/i.test(String(value)) ? String(value).toLowerCase() : undefined;
  }
}

/** Where the second sun stands, in degrees around from the light. */
export const SECOND_LIGHT_AZIMUTH = { left: -90, right: 90, opposite: 180 } as const;

/** Light to printed tone, as the material takes it. */
export const TONE_CURVES = {
  linear: 'linear',
  perceptual: 'perceptual',
  contrast: [
    [0, 0],
    [0.25, 0.1],
    [0.75, 0.9],
    [1, 1],
  ],
} as const satisfies Record<Settings['toneCurve'], unknown>;

/** Whether a technique draws strokes of a width, black or white, instead of blending their grey. */
export function isCrisp(technique: Settings['technique']): boolean {
  return technique === 'anchored' || technique === 'adjacencyCrisp';
}
