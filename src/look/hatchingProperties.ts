// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.
import type { HatchingOwner, HatchingProperty, HatchingTechniqueData } from './HatchingProperty.js';

/**
 * What a surface is drawn with, and how.
 * - `triangle`: Algorithm 1 alone. Every triangle has its own strokes; they break at its edges (paper by Suarez et al.,
 *   figure 4a).
 * - `adjacency`: Algorithms 1 to 3. Every triangle blends in the strokes of its three neighbours (figure 4b).
 * - `hatching`: strokes of a tonal art map in ink. They are anchored to a lattice fixed on the object, and ink is
 *   decided per pixel, after blending: continuous, crisp and independent of the mesh.
 * - `dryMedia`: the same strokes in pencil, charcoal or chalk: a grey that grows with the pressure and catches on the
 *   grain of the paper, which lies on the screen.
 * - `stipple`: dots in the place of strokes, fixed on the surface and round on the screen. `strokeWidth` is the
 *   diameter of a dot at half tone; from a tone of 0.95 on they leave no paper. Draws without a map.
 * - `engraving`: lines that are level sets of a function on the object: they never break, swell with the tone and cross
 *   in the darks, as in an engraved plate. Draws without a map.
 * - `pen`: the same lines in strokes of a pen, which begin and end thin, and are fewer in the lights.
 * - `woodcut`: the same lines cut white out of black: wedges that widen with the light and end in points.
 */
export type HatchingTechnique =
  | 'triangle'
  | 'adjacency'
  | 'hatching'
  | 'dryMedia'
  | 'stipple'
  | 'engraving'
  | 'pen'
  | 'woodcut';

/**
 * What strokes are fixed to on a mesh that deforms.
 * - `rest`: the surface. Stroke coordinates are those of the rest pose, and the light is carried into it.
 * - `deformed`: object space, through which the surface moves; the paper by Suarez et al. to the letter.
 */
export type StrokeAnchor = 'rest' | 'deformed';

/**
 * What strokes and lines take their direction from.
 * - `auto`: the form of a geometry that was prepared for it, and elsewhere `'light'`, with a pen `'slant'`, with a
 *   woodcut `'towardsLight'`. `applyHatching` prepares shapes that have a form, and not machine parts and other meshes
 *   of flat faces.
 * - `light`: the light. Strokes turn with it, at the angle `strokeAngle`, as in the paper by Suarez et al. Lines are
 *   cut by planes across it, or by spheres around a lamp: they run around it, tangent to it.
 * - `towardsLight`: planes that hold the direction of the light: lines run towards it.
 * - `x`: planes across the x axis of the object, or of the scene that `applyHatching` hatched: lines stay where they
 *   are while the light moves.
 * - `y`: the same across its y axis.
 * - `z`: the same across its z axis.
 * - `slant`: planes across an axis that is aslant to x, y and z: lines stay where they are, and run diagonally on
 *   walls, lids and floors.
 * - `form`: functions baked into the geometry: strokes and lines follow the form, around fingers, limbs and cheeks,
 *   whatever the light. `applyHatching` bakes them; for a geometry of your own pass `{ form: true }` to
 *   `prepareHatchingGeometry`.
 * - `acrossForm`: the same, across the form: along limbs instead of around them. Strokes lie across at a right angle;
 *   lines are those that cross the others, as they were baked with a `crossAngle` of π/2.
 * - `sheet`: the sheet: strokes lie one way on it, as one hand draws them, at the angle `strokeAngle` to the
 *   horizontal. They turn with the camera, and not with the light.
 */
export type StrokeDirection =
  | 'auto'
  | 'light'
  | 'towardsLight'
  | 'x'
  | 'y'
  | 'z'
  | 'slant'
  | 'form'
  | 'acrossForm'
  | 'sheet';

/**
 * How many layers of strokes lie over one another. Together they keep the tone.
 * - `single`: one, in one direction, whatever the tone.
 * - `lights`: a second, across the first, where several lights disagree about the direction; the same as `single` with
 *   one light.
 * - `tone`: a second above the tone `crossFrom`, turned by `crossAngle`, and half way from there to 1 a third, turned
 *   into the wider of the two angles between them: the other way at 60°, diagonally at 90°.
 */
export type StrokeLayers = 'single' | 'lights' | 'tone';

/**
 * What cast shadows do to the strokes.
 * - `tone`: darken them.
 * - `cross`: are a layer of strokes of their own, across the others, with a clean edge. The strokes of the light run on
 *   below it.
 * - `reorient`: turn them to the lights that still arrive, hard where half of a light is shadowed; where none arrives,
 *   across the light. `triangle` and `adjacency`, whose frames are made before shadows are known, turn them by a right
 *   angle where shadows take most of the light.
 */
export type ShadowStrokes = 'tone' | 'cross' | 'reorient';

/**
 * How light becomes tone (paper by Suarez et al., section 3.4 and figure 9).
 * - `lambert`: N·L.
 * - `halfLambert`: (N·L / 2 + 1/2)², which reaches round to the side turned away.
 * - `phong`: Lambert plus a highlight (R·V)^shininess.
 * - `toon`: Lambert in `toneSteps` hard bands, each of them one tone.
 */
export type ToneModel = 'lambert' | 'halfLambert' | 'phong' | 'toon';

/**
 * The normal that tone is computed from.
 * - `face`: the normal of the flat triangle, as in the paper by Suarez et al.
 * - `smooth`: the interpolated vertex normal.
 */
export type ToneNormal = 'face' | 'smooth';

/**
 * What ink does to the colour below it.
 * - `cover`: hides it, as gouache or a printer's black.
 * - `multiply`: tints it, as transparent ink.
 */
export type InkBlend = 'cover' | 'multiply';

/**
 * What is drawn in the place of strokes.
 * - `none`: nothing: strokes are drawn.
 * - `blendFactors`: the contributions of α, β, γ as red, green, blue (figure 8).
 * - `tone`: the wanted tone as grey.
 * - `frames`: a checker in the stroke coordinates of the triangle itself.
 */
export type DebugView = 'none' | 'blendFactors' | 'tone' | 'frames';

/**
 * What chooses the level of the tonal art map.
 * - `derivatives`: how fast texture coordinates change on the screen, foreshortening included. Strokes are never finer
 *   than drawn, and wider where the surface is seen at a slant.
 * - `depth`: the depth of the fragment alone (section 3.4). Strokes are as wide as drawn where the surface is seen face
 *   on, and foreshortened like the surface elsewhere.
 */
export type LevelRule = 'derivatives' | 'depth';

/**
 * Which way the strokes of shadows on a ground run.
 * - `away`: in one layer, away from the light: a long stroke thins out along the shadow and ends with it.
 * - `strokes`: as those of any other surface, by all the properties of strokes.
 */
export type ShadowDirection = 'away' | 'strokes';

/** Every property by name: of `HatchingMaterial`, and of the owners that some rows name. */
export const HATCHING_PROPERTIES = {
  tonalArtMap: {
    kind: 'tonalArtMap',
    default: 'hatching',
    techniques: ['triangle', 'adjacency', 'hatching', 'dryMedia'],
  },
  technique: {
    kind: 'choice',
    default: 'hatching',
    define: 'TECHNIQUE',
    choices: ['triangle', 'adjacency', 'hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  tilesPerObjectUnit: { kind: 'number', default: 3, uniform: 'tilesPerObjectUnit', range: { above: 0 } },
  strokeAngle: {
    kind: 'number',
    default: 0,
    defaultFor: { strokes: Math.PI / 2 },
    techniques: ['triangle', 'adjacency', 'hatching', 'dryMedia', 'engraving', 'pen', 'woodcut'],
  },
  strokeAnchor: { kind: 'choice', default: 'rest', define: 'STROKE_ANCHOR', choices: ['rest', 'deformed'] },
  screenSpaceShare: {
    kind: 'number',
    default: 1,
    uniform: 'screenSpaceShare',
    range: { from: 0, to: 1 },
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  strokeWidth: {
    kind: 'number',
    default: null,
    defaultFor: { strokes: 1.5 },
    range: { above: 0 },
    techniques: ['triangle', 'adjacency', 'hatching', 'dryMedia', 'stipple', 'pen'],
  },
  edgePixels: {
    kind: 'number',
    default: 1,
    uniform: 'edgePixels',
    range: { from: 0 },
    techniques: ['triangle', 'adjacency', 'hatching', 'stipple'],
  },
  latticeSpacing: {
    kind: 'number',
    default: 0.4,
    uniform: 'latticeSpacing',
    range: { above: 0 },
    techniques: ['hatching', 'dryMedia'],
  },
  direction: {
    kind: 'choice',
    default: 'light',
    define: 'DIRECTION',
    choices: ['auto', 'light', 'towardsLight', 'x', 'y', 'z', 'slant', 'form', 'acrossForm', 'sheet'],
    choicesFor: {
      strokes: ['light', 'form', 'acrossForm', 'sheet'],
      lines: ['auto', 'light', 'towardsLight', 'x', 'y', 'z', 'slant', 'form', 'acrossForm'],
    },
    techniques: ['hatching', 'dryMedia', 'engraving', 'pen', 'woodcut'],
  },
  hand: { kind: 'hand', default: null, techniques: ['pen'] },
  lineSpacing: {
    kind: 'number',
    default: 4.5,
    uniform: 'lineSpacing',
    range: { above: 0 },
    techniques: ['engraving', 'pen', 'woodcut'],
  },
  minLineSpacing: {
    kind: 'number',
    default: 3,
    uniform: 'minLineSpacing',
    range: { from: 2 },
    techniques: ['engraving', 'pen', 'woodcut'],
  },
  strokeLength: {
    kind: 'number',
    default: 72,
    uniform: 'strokeLength',
    range: { above: 0 },
    techniques: ['pen', 'woodcut'],
  },
  strokeLayers: {
    kind: 'choice',
    default: 'single',
    define: 'STROKE_LAYERS',
    choices: ['single', 'lights', 'tone'],
    defaultFor: { strokes: 'tone' },
    techniques: ['triangle', 'adjacency', 'hatching', 'dryMedia', 'stipple'],
  },
  crossFrom: {
    kind: 'number',
    default: 0.52,
    uniform: 'crossFrom',
    defaultFor: { strokes: 0.6 },
    range: { from: 0, to: 1 },
  },
  crossAngle: { kind: 'number', default: Math.PI / 3, range: { above: 0, to: 1.5707963267948966 } },
  irregularity: {
    kind: 'number',
    default: 0.4,
    uniform: 'irregularity',
    range: { from: 0, to: 1 },
    techniques: ['engraving', 'pen', 'woodcut'],
  },
  shadowStrokes: { kind: 'choice', default: 'tone', define: 'SHADOW_STROKES', choices: ['tone', 'cross', 'reorient'] },
  paperGrain: {
    kind: 'number',
    default: 0.4,
    uniform: 'paperGrain',
    range: { from: 0, to: 1 },
    techniques: ['dryMedia'],
  },
  paperGrainSize: {
    kind: 'number',
    default: 2.5,
    uniform: 'paperGrainSize',
    range: { above: 0 },
    techniques: ['dryMedia'],
  },
  softness: { kind: 'number', default: 0.6, uniform: 'softness', range: { from: 0, to: 1 }, techniques: ['dryMedia'] },
  smudge: { kind: 'number', default: 0, uniform: 'smudge', range: { from: 0, to: 1 }, techniques: ['dryMedia'] },
  toneModel: {
    kind: 'choice',
    default: 'lambert',
    define: 'TONE_MODEL',
    choices: ['lambert', 'halfLambert', 'phong', 'toon'],
  },
  toneSteps: { kind: 'number', default: 4, uniform: 'toneSteps', range: { from: 2 } },
  shininess: { kind: 'number', default: 30, uniform: 'shininess', range: { from: 0 } },
  toneNormal: {
    kind: 'choice',
    default: 'face',
    define: 'TONE_NORMAL',
    choices: ['face', 'smooth'],
    defaultFor: { perTriangle: 'face', strokes: 'smooth', lines: 'smooth' },
  },
  toneCurve: { kind: 'curve', default: 'linear', defaultFor: { strokes: 'printed', lines: 'printed' } },
  reflectedLight: {
    kind: 'number',
    default: 0,
    uniform: 'reflectedLight',
    defaultFor: { strokes: 0.35, lines: 0.4 },
    range: { from: 0, to: 1 },
  },
  metalness: { kind: 'number', default: 0, uniform: 'metalness', range: { from: 0, to: 1 } },
  roughness: { kind: 'number', default: 1, uniform: 'roughness', range: { from: 0, to: 1 } },
  occlusion: { kind: 'number', default: 1, uniform: 'occlusion', range: { from: 0, to: 1 } },
  hollowStrength: {
    kind: 'number',
    default: 0,
    uniform: 'hollowStrength',
    defaultFor: { strokes: 1, lines: 1 },
    range: { from: 0, to: 1 },
  },
  colorHatching: { kind: 'number', default: 0, uniform: 'colorHatching', range: { from: 0, to: 1 } },
  highlightThreshold: { kind: 'number', default: 0, range: { from: 0, to: 1 } },
  highlightSoftness: { kind: 'number', default: 0, range: { from: 0, to: 1 } },
  normalMap: { kind: 'texture', default: null, uniform: 'normalMap', transform: 'normalMapTransform' },
  normalScale: { kind: 'vector2', default: [1, 1], uniform: 'normalScale' },
  bumpMap: { kind: 'texture', default: null, uniform: 'bumpMap', transform: 'bumpMapTransform' },
  bumpScale: { kind: 'number', default: 1, uniform: 'bumpScale' },
  flatShading: { kind: 'switch', default: false, define: 'FLAT_SHADING' },
  aoMap: { kind: 'texture', default: null, uniform: 'aoMap', transform: 'aoMapTransform' },
  aoMapIntensity: { kind: 'number', default: 1, uniform: 'aoMapIntensity', range: { from: 0 } },
  lightMap: { kind: 'texture', default: null, uniform: 'lightMap', transform: 'lightMapTransform' },
  lightMapIntensity: { kind: 'number', default: 1, uniform: 'lightMapIntensity', range: { from: 0 } },
  emissive: { kind: 'color', default: 0x000000, uniform: 'emissive' },
  emissiveIntensity: { kind: 'number', default: 1, uniform: 'emissiveIntensity', range: { from: 0 } },
  emissiveMap: { kind: 'texture', default: null, uniform: 'emissiveMap', transform: 'emissiveMapTransform' },
  ink: { kind: 'color', default: 0x000000, uniform: 'ink' },
  paper: { kind: 'color', default: 0xffffff, uniform: 'paper' },
  color: { kind: 'color', default: 0xffffff, uniform: 'diffuse' },
  colorFill: { kind: 'number', default: 1, uniform: 'colorFill', range: { from: 0, to: 1 } },
  inkBlend: { kind: 'choice', default: 'cover', define: 'INK_BLEND', choices: ['cover', 'multiply'] },
  paperOpacity: { kind: 'number', default: 1, uniform: 'paperOpacity', range: { from: 0, to: 1 } },
  map: { kind: 'texture', default: null, uniform: 'map', transform: 'mapTransform' },
  alphaMap: { kind: 'texture', default: null, uniform: 'alphaMap', transform: 'alphaMapTransform' },
  debugView: {
    kind: 'choice',
    default: 'none',
    define: 'DEBUG_VIEW',
    choices: ['none', 'blendFactors', 'tone', 'frames'],
  },
  exposure: { kind: 'number', default: 1, owner: 'composition', range: { above: 0 }, words: ['fit', 'auto'] },
  exposureCompensation: { kind: 'number', default: 1, owner: 'composition', range: { above: 0 } },
  plannedValues: { kind: 'number', default: 1, owner: 'composition', range: { from: 0, to: 1 } },
  depthFade: {
    kind: 'number',
    default: 'auto',
    owner: 'composition',
    range: { from: 0, to: 1 },
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  depthFadeStart: {
    kind: 'number',
    default: 0,
    owner: 'composition',
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  depthFadeEnd: {
    kind: 'number',
    default: 1,
    owner: 'composition',
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  focus: {
    kind: 'point',
    default: null,
    owner: 'composition',
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  focusRadius: {
    kind: 'number',
    default: 1,
    owner: 'composition',
    range: { above: 0 },
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  vignette: {
    kind: 'number',
    default: 0,
    owner: 'composition',
    range: { from: 0, to: 1 },
    techniques: ['hatching', 'dryMedia', 'stipple', 'engraving', 'pen', 'woodcut'],
  },
  strokeOffset: { kind: 'vector2', default: [0, 0], owner: 'perTriangle', techniques: ['triangle', 'adjacency'] },
  sharpInk: {
    kind: 'switch',
    default: false,
    owner: 'perTriangle',
    define: 'SHARP_INK',
    techniques: ['triangle', 'adjacency'],
  },
  levelRule: {
    kind: 'choice',
    default: 'derivatives',
    owner: 'perTriangle',
    define: 'LEVEL_RULE',
    choices: ['derivatives', 'depth'],
    techniques: ['triangle', 'adjacency'],
  },
  blendAngle: {
    kind: 'number',
    default: Math.PI / 2,
    owner: 'perTriangle',
    range: { from: 0, to: Math.PI },
    techniques: ['adjacency'],
  },
  shadowTone: {
    kind: 'number',
    default: 1,
    owner: 'shadowMaterial',
    uniform: 'shadowTone',
    defaultFor: { strokes: 0.5, lines: 0.5 },
    range: { from: 0, to: 1 },
  },
  shadowFade: {
    kind: 'number',
    default: 0,
    owner: 'shadowMaterial',
    uniform: 'shadowFade',
    defaultFor: { strokes: 0.65, lines: 0.65 },
    range: { from: 0 },
  },
  shadowSoftness: {
    kind: 'number',
    default: 0,
    owner: 'shadowMaterial',
    uniform: 'shadowSoftness',
    defaultFor: { strokes: 0.12, lines: 0.12 },
    range: { from: 0 },
  },
  shadowDirection: {
    kind: 'choice',
    default: 'strokes',
    owner: 'shadowMaterial',
    define: 'SHADOW_DIRECTION',
    choices: ['away', 'strokes'],
    defaultFor: { perTriangle: 'strokes', strokes: 'away', lines: 'away' },
  },
  shadowSpacing: {
    kind: 'number',
    default: 1.4,
    owner: 'shadowMaterial',
    uniform: 'shadowSpacing',
    range: { above: 0 },
    techniques: ['engraving', 'pen', 'woodcut'],
  },
} as const satisfies Record<string, HatchingProperty>;

export type HatchingPropertyName = keyof typeof HATCHING_PROPERTIES;

/** The names of the properties of an owner; `undefined` stands for `HatchingMaterial` itself. */
export type PropertyNameOf<Owner extends HatchingOwner | undefined> = {
  [Name in HatchingPropertyName]: OwnerOf<(typeof HATCHING_PROPERTIES)[Name]> extends Owner ? Name : never;
}[HatchingPropertyName];

type OwnerOf<Property> = Property extends { owner: infer Owner } ? Owner : undefined;

/** The default of every property; colours as 0xrrggbb. */
export const HATCHING_DEFAULTS = /* @__PURE__ */ defaults();

function defaults(): { readonly [Name in HatchingPropertyName]: (typeof HATCHING_PROPERTIES)[Name]['default'] } {
  const entries = Object.entries(HATCHING_PROPERTIES).map(([name, property]) => [name, property.default]);
  return Object.fromEntries(entries);
}

/** Facts of every technique. */
export const HATCHING_TECHNIQUES = {
  triangle: { family: 'perTriangle', map: 'tonalArtMap' },
  adjacency: { family: 'perTriangle', map: 'tonalArtMap' },
  hatching: { family: 'strokes', map: 'thresholdMap' },
  dryMedia: { family: 'strokes', map: 'thresholdMap' },
  stipple: { family: 'strokes', map: 'none' },
  engraving: { family: 'lines', map: 'none' },
  pen: { family: 'lines', map: 'none' },
  woodcut: { family: 'lines', map: 'none' },
} as const satisfies Record<HatchingTechnique, HatchingTechniqueData>;
