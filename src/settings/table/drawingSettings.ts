import type { HatchingTechnique, StrokeStyleName } from 'three-hatching';
import { choiceOf } from './materialRows.js';
import { inGroup } from './Setting.js';

/** The techniques, as the page names them: crisp strokes, a property of their own, are offered as one of them. */
const TECHNIQUES = {
  anchored: 'Anchored',
  engraved: 'Engraved',
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

/** What is drawn, and the first choices of how. */
export const DRAWING_SETTINGS = inGroup('Drawing', 'hand', {
  model: { kind: 'choice', label: 'Model', owner: 'subject', default: 'dragon3', choices: MODELS },
  technique: { kind: 'choice', label: 'Technique', partOf: 'technique', default: 'anchored', choices: TECHNIQUES },
  compare: {
    kind: 'choice',
    label: 'Compare with',
    owner: 'subject',
    default: 'none',
    choices: { none: 'Nothing', ...TECHNIQUES },
  },
  mapStyle: { kind: 'choice', label: 'Style', partOf: 'tonalArtMap', default: 'hatching', choices: STYLES },
  boldness: {
    kind: 'number',
    label: 'Strokes',
    default: 100,
    unit: '%',
    min: 50,
    max: 200,
    step: 1,
    ends: ['fine', 'bold'],
  },
  density: {
    kind: 'number',
    label: 'Cover',
    default: 100,
    unit: '%',
    min: 50,
    max: 200,
    step: 1,
    ends: ['sparse', 'dense'],
  },
  strokeField: choiceOf('strokeField', {
    label: 'Strokes follow',
    choices: { light: 'The light', form: 'The form', acrossForm: 'Across the form', sheet: 'The sheet' },
  }),
  lineField: choiceOf('lineField', {
    label: 'Lines follow',
    default: 'light',
    choices: {
      auto: 'The form, if there is one',
      light: 'The light',
      towards: 'Towards the light',
      x: 'An axis: x',
      y: 'An axis: y',
      z: 'An axis: z',
      slant: 'A slant',
      form: 'The form',
      acrossForm: 'Across the form',
    },
  }),
  strokeDirection: {
    kind: 'choice',
    label: 'Direction',
    partOf: 'strokeRotation',
    yieldsTo: 'lineField',
    default: 'towards',
    choices: { along: 'Around the light', towards: 'Towards the light', angle: 'At an angle' },
  },
  strokeAngle: {
    kind: 'number',
    label: 'Angle',
    partOf: 'strokeRotation',
    yieldsTo: 'lineField',
    when: { strokeDirection: ['angle'] },
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
