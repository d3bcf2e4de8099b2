import { choiceOf, numberOf } from './materialRows.js';
import { inGroup, type SettingRow } from './Setting.js';

const offset = (label: string) =>
  ({
    kind: 'number',
    label,
    partOf: 'strokeOffset',
    default: 0,
    unit: 'tiles',
    min: 0,
    max: 1,
    step: 0.01,
  }) as const satisfies SettingRow;

/** The strokes and their tonal art map. */
export const STROKE_SETTINGS = inGroup('More', 'hand', {
  sizedOnScreen: numberOf('sizedOnScreen', {
    label: 'Stroke size',
    default: 0,
    ends: ['on the object', 'on the screen'],
  }),
  strokeWidth: numberOf('strokeWidth', { label: 'Stroke width', default: 1.5, min: 0.5, max: 8 }),
  tilesPerUnit: numberOf('tilesPerUnit', {
    label: 'Stroke scale',
    default: 2.5,
    min: 0.5,
    max: 8,
    staysInPlace: true,
  }),
  lineSpacing: numberOf('lineSpacing', { label: 'Spacing', default: 4, min: 2, max: 20 }),
  strokeLength: numberOf('strokeLength', { label: 'Length', min: 10, max: 300 }),
  strokeLayers: choiceOf('strokeLayers', {
    label: 'Layers',
    default: 'lights',
    choices: { single: 'One', lights: 'Where lights cross', tone: 'More in the darks' },
    leftOut: ['auto'],
  }),
  crossFrom: numberOf('crossFrom', { label: 'Crossing from' }),
  crossAngle: numberOf('crossAngle', { label: 'Crossing at', min: 10 }),
  handmade: numberOf('handmade', { label: 'Handmade' }),
  anchorSpacing: numberOf('anchorSpacing', { label: 'Anchors', default: 0.4, min: 0.1, max: 1 }),
  edge: numberOf('edgePixels', { label: 'Soft edge', max: 4 }),
  medium: choiceOf('medium', {
    label: 'Medium',
    choices: {
      ink: 'Ink',
      dry: 'Pencil or chalk',
      stipple: 'Dots',
      pen: 'Pen, in strokes',
      woodcut: 'Cut white out of black',
    },
  }),
  tooth: numberOf('tooth', { label: 'Paper tooth' }),
  toothSize: numberOf('toothSize', { label: 'Tooth size', min: 0.5, max: 12 }),
  softness: numberOf('softness', { label: 'Softness' }),
  smudge: numberOf('smudge', { label: 'Smudge' }),
  offsetU: offset('Shift along'),
  offsetV: offset('Shift across'),
  levelRule: choiceOf('levelRule', {
    label: 'Levels',
    choices: { derivatives: 'By depth and slant', depth: 'By depth alone' },
  }),
  mapTones: {
    kind: 'number',
    label: 'Tones',
    partOf: 'tonalArtMap',
    default: 8,
    unit: '',
    min: 4,
    max: 16,
    step: 1,
  },
  mapSize: {
    kind: 'choice',
    label: 'Tile size',
    partOf: 'tonalArtMap',
    default: '256',
    choices: { 64: '64 px', 128: '128 px', 256: '256 px', 512: '512 px' },
  },
  mapSeed: { kind: 'number', label: 'Seed', partOf: 'tonalArtMap', default: 1, unit: '', min: 1, max: 99, step: 1 },
  renderer: {
    kind: 'choice',
    label: 'Renderer',
    owner: 'subject',
    default: 'webgl',
    choices: { webgl: 'WebGL', webgpu: 'WebGPU, experimental' },
  },
});
