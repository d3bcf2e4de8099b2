import type { HatchingTechnique, StrokeStyleName } from 'three-hatching';
import { HATCHING_DEFAULTS, HATCHING_OUTLINE_DEFAULTS } from 'three-hatching/facts';
import { resolveMapDrawing } from '../../../strokes/tamImages/hatchImageOptions.js';
import { PAGE_DEFAULTS } from './pageDefaults.js';
import { choiceOf, inGroup, libraryDefault, numberOf, outlineOf, percent, type SettingRow } from './rows.js';

/** The library's map. */
const MAP = resolveMapDrawing();

/** Labels of the techniques. Crisp strokes, a property of the material, are offered as a technique. */
const TECHNIQUES = {
  hatching: 'Hatching',
  dryMedia: 'Pencil, charcoal, chalk',
  stipple: 'Dots',
  engraving: 'Engraving',
  pen: 'Pen strokes',
  woodcut: 'Woodcut',
  adjacency: 'Adjacency',
  adjacencyCrisp: 'Adjacency, crisp',
  triangle: 'Per triangle',
} as const satisfies Record<HatchingTechnique | 'adjacencyCrisp', string>;

const MODELS = {
  dragon4: 'Dragon, 11 thousand',
  dragon3: 'Dragon, 48 thousand',
  dragon2: 'Dragon, 202 thousand',
  dragon1: 'Dragon, 871 thousand',
  bunny: 'Bunny',
  suzanne: 'Suzanne',
  teapot: 'Teapot',
  fish: 'Fish, swimming',
  hand: 'Hand',
  bust: 'Bust',
  shell: 'Shell',
  vase: 'Vase',
  column: 'Column',
  gears: 'Gears',
  landscape: 'Landscape',
  knot: 'Knot',
  house: 'House',
  drapery: 'Draped cloth',
  stairs: 'Staircase',
  room: 'Room',
  street: 'Street',
  fox: 'Fox, low polygons',
  cube: 'Cube',
  sphere: 'Sphere',
  file: 'Your own',
} as const satisfies Record<string, string>;

const STYLES = {
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
  ownHand: 'Your own hand',
  file: 'Your own',
} as const satisfies Record<StrokeStyleName | 'ownHand' | 'file', string>;

/** The values of `strokeAngle` that have a name on the page. */
export const STROKE_ANGLES = { along: 0, towards: Math.PI / 2 } as const;

/** The name of a `strokeAngle`. */
export const strokeTurnOf = (rotation: unknown): keyof typeof STROKE_ANGLES | 'angle' =>
  rotation === STROKE_ANGLES.along ? 'along' : rotation === STROKE_ANGLES.towards ? 'towards' : 'angle';

/** The technique, and the main choices that go with it. */
export const DRAWING_SETTINGS = inGroup('Drawing', 'hand', {
  model: { kind: 'choice', label: 'Model', owner: 'subject', default: 'dragon3', choices: MODELS },
  technique: {
    kind: 'choice',
    label: 'Technique',
    partOf: 'technique',
    default: HATCHING_DEFAULTS.technique,
    choices: TECHNIQUES,
  },
  compare: {
    kind: 'choice',
    label: 'Compare with',
    owner: 'subject',
    default: 'none',
    choices: { none: 'Nothing', ...TECHNIQUES },
  },
  mapStyle: { kind: 'choice', label: 'Style', partOf: 'tonalArtMap', default: MAP.style, choices: STYLES },
  boldness: percent('Strokes', 100, { min: 50, max: 200, ends: ['fine', 'bold'] }),
  density: percent('Cover', 100, { min: 50, max: 200, ends: ['sparse', 'dense'] }),
  direction: choiceOf('direction', {
    label: 'Direction',
    choices: {
      auto: 'The form, if there is one',
      light: 'The light',
      towardsLight: 'Towards the light',
      x: 'An axis: x',
      y: 'An axis: y',
      z: 'An axis: z',
      slant: 'A slant',
      form: 'The form',
      acrossForm: 'Across the form',
      sheet: 'The sheet',
    },
  }),
  strokeTurn: {
    kind: 'choice',
    label: 'Strokes run',
    partOf: 'strokeAngle',
    isForStrokes: true,
    default: strokeTurnOf(libraryDefault('strokeAngle')),
    choices: { along: 'Around the light', towards: 'Towards the light', angle: 'At an angle' },
  },
  strokeAngle: {
    kind: 'number',
    label: 'Angle',
    partOf: 'strokeAngle',
    isForStrokes: true,
    when: { strokeTurn: ['angle'] },
    default: 45,
    unit: '°',
    min: 0,
    max: 180,
    step: 1,
  },
  lightKind: {
    kind: 'choice',
    label: 'Light',
    owner: 'subject',
    default: 'directional',
    choices: { directional: 'Sun', point: 'Lamp', spot: 'Spot' },
  },
});

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
  screenSpaceShare: numberOf('screenSpaceShare', {
    label: 'Stroke size',
    ends: ['on the object', 'on the screen'],
  }),
  strokeWidth: numberOf('strokeWidth', { label: 'Stroke width', min: 0.5, max: 8 }),
  tilesPerObjectUnit: numberOf('tilesPerObjectUnit', {
    label: 'Stroke scale',
    min: 0.5,
    max: 8,
    staysInPlace: true,
  }),
  lineSpacing: numberOf('lineSpacing', { label: 'Spacing', min: 2, max: 20 }),
  strokeLength: numberOf('strokeLength', { label: 'Length', min: 10, max: 300 }),
  strokeLayers: choiceOf('strokeLayers', {
    label: 'Layers',
    choices: { single: 'One', lights: 'Where lights cross', tone: 'More in the darks' },
    leftOut: ['auto'],
  }),
  crossFrom: numberOf('crossFrom', { label: 'Crossing from' }),
  crossAngle: numberOf('crossAngle', { label: 'Crossing at', min: 10 }),
  irregularity: numberOf('irregularity', { label: 'Irregularity' }),
  latticeSpacing: numberOf('latticeSpacing', { label: 'Anchors', min: 0.1, max: 1 }),
  edge: numberOf('edgePixels', { label: 'Soft edge', max: 4 }),
  paperGrain: numberOf('paperGrain', { label: 'Paper grain' }),
  paperGrainSize: numberOf('paperGrainSize', { label: 'Grain size', min: 0.5, max: 12 }),
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
    default: MAP.tones,
    unit: '',
    min: 4,
    max: 16,
    step: 1,
  },
  mapSize: {
    kind: 'choice',
    label: 'Tile size',
    partOf: 'tonalArtMap',
    default: String(MAP.size),
    choices: { 64: '64 px', 128: '128 px', 256: '256 px', 512: '512 px' },
  },
  mapSeed: {
    kind: 'number',
    label: 'Seed',
    partOf: 'tonalArtMap',
    default: MAP.seed,
    unit: '',
    min: 1,
    max: 99,
    step: 1,
  },
  renderer: {
    kind: 'choice',
    label: 'Renderer',
    owner: 'subject',
    default: 'webgl',
    choices: { webgl: 'WebGL', webgpu: 'WebGPU, experimental' },
  },
});

/** The share of its weight that an outline loses in full light and gains in full shade, at a shade weight of 100 %. */
export const SHADE = { lost: 0.75, gained: 1.75 } as const;

/** The setting for a weight on the lit side. */
export const outlineShadeOf = (lit: number): number => Math.round((100 * (1 - lit)) / SHADE.lost);

const DRAWN = { outlines: ['on'] } as const;

/** Contours, creases and the like. */
export const OUTLINE_SETTINGS = inGroup('Outlines', 'hand', {
  outlines: { kind: 'choice', label: 'Outlines', default: 'on', choices: { on: 'Drawn', off: 'None' } },
  outlineWidth: outlineOf('outlineWidth', 'px', { label: 'Outline width', min: 0.4 }),
  outlineContours: outlineOf('contours', '%', { label: 'Contours' }),
  outlineInner: outlineOf('innerContours', '%', { label: 'Inner contours', max: 100 }),
  outlineBorders: outlineOf('borders', '%', { label: 'Borders' }),
  outlineCreases: outlineOf('creases', '%', { label: 'Creases' }),
  outlineSuggestive: outlineOf('suggestiveContours', '%', { label: 'Suggestive', ends: ['none', 'in folds'] }),
  outlineShade: percent('Shade', outlineShadeOf(HATCHING_OUTLINE_DEFAULTS.weights.lit), {
    when: DRAWN,
    ends: ['even', 'thin in light'],
  }),
  outlineLost: outlineOf('lostEdges', '%', { label: 'Lost edges', max: 100, ends: ['closed', 'open in light'] }),
  outlineAccents: outlineOf('accents', '%', { label: 'Accents', ends: ['none', 'where forms overlap'] }),
  outlineHidden: {
    kind: 'choice',
    label: 'Hidden',
    when: DRAWN,
    default: HATCHING_OUTLINE_DEFAULTS.hidden,
    choices: { none: 'Not drawn', dashed: 'Dashed', faint: 'Faint' },
  },
  outlineMeetings: {
    kind: 'choice',
    label: 'Where parts meet',
    when: DRAWN,
    default: PAGE_DEFAULTS.outlineMeetings,
    choices: { on: 'Drawn', off: 'Not drawn' },
  },
  outlineHand: {
    ...outlineOf('wobble', 'px', { label: 'Hand', max: 4, ends: ['ruled', 'loose'] }),
    default: PAGE_DEFAULTS.outlineHand,
  },
});
