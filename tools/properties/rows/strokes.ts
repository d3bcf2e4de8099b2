import { LINES_FAMILY, ofTechniques, PER_TRIANGLE, STROKES_FAMILY, WITH_MAP } from '../ofTechniques.js';
import type { PropertyRow } from '../PropertyRow.js';

/** The techniques whose lines or strokes have a direction: dots have none. */
const DIRECTED = [...WITH_MAP, ...LINES_FAMILY];

/** The choices of `direction` that strokes of a map know, and those that lines know. */
const OF_STROKES = ['light', 'form', 'acrossForm', 'sheet'];
const OF_LINES = ['auto', 'light', 'towardsLight', 'x', 'y', 'z', 'slant', 'form', 'acrossForm'];

/** The properties of strokes: where they lie, how large they are, which way they run. */
export const STROKES = {
  tonalArtMap: {
    kind: 'tonalArtMap',
    group: 'Strokes',
    default: 'hatching',
    techniques: WITH_MAP,
    sentence:
      'The hatch images: a map, which materials may share and which you dispose of yourself; or the name of a style, whose map all materials share (`TonalArtMap.shared`), drawn with the first frame that needs it. Until a map is ready the surface is blank paper, and with `null` it stays so.',
  },
  technique: {
    kind: 'choice',
    group: 'Strokes',
    type: 'HatchingTechnique',
    typeSentence: 'What a surface is drawn with, and how.',
    choices: ofTechniques(({ sentence }) => sentence),
    default: 'hatching',
    sentence: 'What a surface is drawn with, and how.',
  },
  tilesPerObjectUnit: {
    kind: 'number',
    group: 'Strokes',
    default: 3,
    measure: 'tilesPerObjectUnit',
    range: { above: 0 },
    when: { screenSpaceShare: { not: 1 } },
    sentence: 'Size of the strokes: larger is finer.',
  },
  strokeAngle: {
    kind: 'number',
    group: 'Strokes',
    default: 0,
    defaultFor: { strokes: Math.PI / 2 },
    measure: 'radians',
    uniform: false,
    techniques: DIRECTED,
    when: { direction: ['auto', 'light', 'towardsLight', 'sheet'] },
    sentence:
      "How far strokes are turned, counterclockwise, as seen from outside. Where they follow the light, 0 draws them tangent to it, π/2 towards it (figure 14); with `direction: 'sheet'` it is their angle to the horizontal of the sheet. Of lines it turns what cuts them, where a light does: at π/2 `direction: 'light'` is `'towardsLight'`. Half a turn more is the same direction.",
  },
  strokeAnchor: {
    kind: 'choice',
    group: 'Strokes',
    type: 'StrokeAnchor',
    typeSentence: 'What strokes are fixed to on a mesh that deforms.',
    choices: {
      rest: 'the surface. Stroke coordinates are those of the rest pose, and the light is carried into it.',
      deformed: 'object space, through which the surface moves; the paper by Suarez et al. to the letter.',
    },
    default: 'rest',
    sentence:
      'What the strokes of a mesh that deforms are fixed to ([geometry.md](geometry.md#skins-and-morph-targets)).',
  },
  screenSpaceShare: {
    kind: 'number',
    group: 'Strokes',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques: [...STROKES_FAMILY, ...LINES_FAMILY],
    sentence:
      'What strokes are sized on: 0 the object, by `tilesPerObjectUnit`; 1 the screen, by `strokeWidth`, without popping. In between, strokes grow less than the object does as the camera comes nearer. Strokes and dots have a program of their own for 0, which is cheaper.',
  },
  strokeWidth: {
    kind: 'number',
    group: 'Strokes',
    default: null,
    defaultFor: { strokes: 1.5 },
    measure: 'pixels',
    range: { above: 0 },
    uniform: false,
    techniques: [...PER_TRIANGLE, ...STROKES_FAMILY, 'pen'],
    when: [
      { sharpInk: [true], hand: { not: null } },
      { levelRule: ['depth'], hand: { not: null } },
    ],
    sentence:
      'Width of a stroke on the screen, which is also where coarser levels of the map take over, unless blended greys choose them by derivatives; of a `pen`, the width of the strokes of its `hand`. `null` leaves it to the technique: for `triangle` and `adjacency` it is as wide as the map draws strokes, `tonalArtMap.strokeTexels` pixels.',
  },
  edgePixels: {
    kind: 'number',
    group: 'Strokes',
    default: 1,
    measure: 'gridPixels',
    range: { from: 0 },
    techniques: [...PER_TRIANGLE, 'hatching', 'stipple'],
    when: { sharpInk: [true] },
    sentence:
      'Width over which ink fades at the edge of a stroke or a dot. 0 is hard. Dry media have `softness` instead.',
  },
  latticeSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 0.4,
    measure: 'tiles',
    range: { above: 0 },
    techniques: ['hatching', 'dryMedia'],
    sentence:
      'Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter strokes.',
  },
  direction: {
    kind: 'choice',
    group: 'Strokes',
    type: 'StrokeDirection',
    typeSentence: 'What strokes and lines take their direction from.',
    choices: {
      auto: "the form of a geometry that was prepared for it, and elsewhere `'light'`, with a pen `'slant'`, with a woodcut `'towardsLight'`. `applyHatching` prepares shapes that have a form, and not machine parts and other meshes of flat faces.",
      light:
        'the light. Strokes turn with it, at the angle `strokeAngle`, as in the paper by Suarez et al. Lines are cut by planes across it, or by spheres around a lamp: they run around it, tangent to it.',
      towardsLight: 'planes that hold the direction of the light: lines run towards it.',
      x: 'planes across the x axis of the object, or of the scene that `applyHatching` hatched: lines stay where they are while the light moves.',
      y: 'the same across its y axis.',
      z: 'the same across its z axis.',
      slant:
        'planes across an axis that is aslant to x, y and z: lines stay where they are, and run diagonally on walls, lids and floors.',
      form: 'functions baked into the geometry: strokes and lines follow the form, around fingers, limbs and cheeks, whatever the light. `applyHatching` bakes them; for a geometry of your own pass `{ form: true }` to `prepareHatchingGeometry` ([engraving.md](engraving.md#lines-along-the-form)).',
      acrossForm:
        'the same, across the form: along limbs instead of around them. Strokes lie across at a right angle; lines are those that cross the others, as they were baked with a `crossAngle` of π/2.',
      sheet:
        'the sheet: strokes lie one way on it, as one hand draws them, at the angle `strokeAngle` to the horizontal. They turn with the camera, and not with the light.',
    },
    default: 'light',
    choicesFor: { strokes: OF_STROKES, lines: OF_LINES },
    techniques: ['hatching', 'dryMedia', ...LINES_FAMILY],
    sentence:
      "What strokes and lines take their direction from. Strokes of `hatching` and `dryMedia` know `'light'`, `'form'`, `'acrossForm'` and `'sheet'`; lines of `engraving`, `pen` and `woodcut` know all but `'sheet'`. Another counts as the default.",
  },
  hand: {
    kind: 'hand',
    group: 'Strokes',
    default: null,
    techniques: ['pen'],
    sentence:
      "A hand from `learnHand`, whose whole strokes are drawn ([hand.md](hand.md#strokes-of-a-hand-on-a-model)): at `strokeWidth`, or with `null` a millimetre of the sheet six pixels long. Their lengths, distances and crossings are the hand's, in place of `lineSpacing`, `strokeLength`, `crossFrom`, `crossAngle` and `irregularity`. Another hand builds no other program; `null` draws the pen's own strokes.",
  },
  lineSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 4.5,
    measure: 'tileParts',
    measureOnScreen: 'pixels',
    range: { above: 0 },
    techniques: LINES_FAMILY,
    when: { hand: [null] },
    sentence:
      'Distance between lines. Where that is less than `minLineSpacing`, every other line is left out. As the camera comes nearer new lines appear between them, thin at first.',
  },
  minLineSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 3,
    measure: 'pixels',
    range: { from: 2 },
    techniques: LINES_FAMILY,
    sentence:
      'Least distance between lines; never less than two pixels of the drawing buffer. Where lines would lie closer, every other one is left out. Below three pixels lines flicker in motion.',
  },
  strokeLength: {
    kind: 'number',
    group: 'Strokes',
    default: 72,
    measure: 'tileParts',
    measureOnScreen: 'pixels',
    range: { above: 0 },
    techniques: ['pen', 'woodcut'],
    when: { hand: [null] },
    sentence:
      'Length of a stroke of `pen`, and of a wedge of `woodcut`: from 0.7 to 1.4 times as much, since strokes give way to others half as long as the camera comes nearer.',
  },
  strokeLayers: {
    kind: 'choice',
    group: 'Strokes',
    type: 'StrokeLayers',
    typeSentence: 'How many layers of strokes lie over one another. Together they keep the tone.',
    choices: {
      single: 'one, in one direction, whatever the tone.',
      lights:
        'a second, across the first, where several lights disagree about the direction; the same as `single` with one light.',
      tone: 'a second above the tone `crossFrom`, turned by `crossAngle`, and half way from there to 1 a third, turned into the wider of the two angles between them: the other way at 60°, diagonally at 90°.',
    },
    default: 'single',
    defaultFor: { strokes: 'tone' },
    techniques: [...PER_TRIANGLE, ...STROKES_FAMILY],
    sentence: 'How many layers of strokes there are.',
  },
  crossFrom: {
    kind: 'number',
    group: 'Strokes',
    default: 0.52,
    defaultFor: { strokes: 0.6 },
    measure: 'tone',
    range: { from: 0, to: 1 },
    when: { strokeLayers: ['tone'], hand: [null] },
    sentence:
      "Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of an engraving, a pen or a woodcut; at 1 none do.",
  },
  crossAngle: {
    kind: 'number',
    group: 'Strokes',
    default: Math.PI / 3,
    defaultSource: 'Math.PI / 3',
    measure: 'radians',
    range: { above: 0, to: Math.PI / 2 },
    uniform: false,
    when: { strokeLayers: ['tone'], hand: [null] },
    sentence:
      "Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that cut the first lines and those that cut the lines across them; lines that follow the form cross as they were baked. 60° is a pen's, 90° an engraver's.",
  },
  irregularity: {
    kind: 'number',
    group: 'Strokes',
    default: 0.4,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques: LINES_FAMILY,
    when: { hand: [null] },
    sentence:
      'How unsteady the hand is: lines differ in width, stray, and have gaps in the lights. 0 is a ruling machine.',
  },
  shadowStrokes: {
    kind: 'choice',
    group: 'Strokes',
    type: 'ShadowStrokes',
    typeSentence: 'What cast shadows do to the strokes.',
    choices: {
      tone: 'darken them.',
      cross:
        'are a layer of strokes of their own, across the others, with a clean edge. The strokes of the light run on below it.',
      reorient:
        'turn them to the lights that still arrive, hard where half of a light is shadowed; where none arrives, across the light. `triangle` and `adjacency`, whose frames are made before shadows are known, turn them by a right angle where shadows take most of the light.',
    },
    default: 'tone',
    sentence: 'What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all.',
  },
} as const satisfies Record<string, PropertyRow>;
