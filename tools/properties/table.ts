import type { PropertyRow } from './PropertyRow.js';
import { TECHNIQUES, type TechniqueRow } from './techniques.js';

type Techniques = keyof typeof TECHNIQUES;

const ofTechniques = (read: (row: TechniqueRow) => string): Record<Techniques, string> =>
  Object.fromEntries(Object.entries(TECHNIQUES).map(([name, row]) => [name, read(row)])) as Record<Techniques, string>;

/** Techniques whose strokes come from a map. */
const WITH_MAP = ['triangle', 'adjacency', 'anchored'] as const;

/**
 * Every property of `HatchingMaterial`. `npm run properties` writes from it the fields with their documentation, what the
 * material needs to know of them at run time, and the table in docs/material.md.
 */
export const PROPERTIES = {
  tonalArtMap: {
    kind: 'tonalArtMap',
    group: 'Strokes',
    default: null,
    sentence:
      'The hatch images. Materials may share it. The material does not own it: dispose of it yourself. Without one the surface stays blank; `anchored` and `crisp` strokes are ink then where no light arrives at all.',
  },
  technique: {
    kind: 'choice',
    group: 'Strokes',
    type: 'HatchingTechnique',
    typeSentence: 'How strokes are laid on the surface.',
    choices: ofTechniques(({ sentence }) => sentence),
    isDefine: false,
    default: 'adjacency',
    sentence: 'How strokes are laid on the surface.',
  },
  strokeScale: {
    kind: 'number',
    group: 'Strokes',
    default: 3,
    measure: 'tilesPerUnit',
    range: { above: 0 },
    sentence: 'Size of the strokes: larger is finer.',
  },
  strokeRotation: {
    kind: 'number',
    group: 'Strokes',
    default: 0,
    measure: 'radians',
    uniform: false,
    techniques: [...WITH_MAP, 'engraved'],
    sentence:
      "Direction of the strokes, clockwise about the normal, as seen from outside: 0 draws them tangent to the light, π/2 towards it (figure 14). For `engraved` it turns what cuts the lines, where a light does: at π/2 `lineField: 'light'` is `'towards'`.",
  },
  strokeOffset: {
    kind: 'vector2',
    group: 'Strokes',
    default: [0, 0],
    measure: 'tiles',
    uniform: false,
    techniques: ['triangle', 'adjacency'],
    sentence: 'Shift of the strokes along T and B.',
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
    sentence: 'What the strokes of a mesh that deforms are fixed to ([deformation.md](deformation.md)).',
  },
  crisp: {
    kind: 'switch',
    group: 'Strokes',
    default: false,
    techniques: ['triangle', 'adjacency'],
    sentence:
      'Blends the thresholds that ink is decided from instead of the greys of the strokes, so that strokes stay black and white. Off is the way of the paper by Suarez et al.',
  },
  levelRule: {
    kind: 'choice',
    group: 'Strokes',
    type: 'LevelRule',
    typeSentence: 'What the level of the tonal art map is chosen by.',
    choices: {
      derivatives:
        'how fast texture coordinates change on the screen, foreshortening included. Strokes are never finer than drawn, and wider where the surface is seen at a slant.',
      depth:
        'the depth of the fragment alone (section 3.4). Strokes are as wide as drawn where the surface is seen face on, and foreshortened like the surface elsewhere.',
    },
    default: 'derivatives',
    techniques: ['triangle', 'adjacency'],
    sentence: 'What the level of the map is chosen by. `anchored` always goes by depth.',
  },
  screenConstancy: {
    kind: 'number',
    group: 'Strokes',
    default: 0,
    range: { from: 0, to: 1 },
    techniques: ['anchored', 'engraved'],
    sentence:
      'What strokes are sized on: 0 the object, by `strokeScale`; 1 the screen, by `texelPixels`, without popping. In between, strokes grow less than the object does as it comes nearer. `anchored` has a program of its own for 0, which is cheaper.',
  },
  texelPixels: {
    kind: 'number',
    group: 'Strokes',
    default: 1,
    measure: 'pixels',
    range: { above: 0 },
    uniform: false,
    clears: 'strokeWidth',
    techniques: WITH_MAP,
    sentence:
      'Size of a texel of the map on the screen, where `anchored` sizes strokes on the screen; also where coarser levels of the map take over, unless blended greys choose them by derivatives. Strokes are `tonalArtMap.strokeWidth` texels wide.',
  },
  // After texelPixels, so that copied in this order the one that was set remains.
  strokeWidth: {
    kind: 'number',
    group: 'Strokes',
    default: null,
    measure: 'pixels',
    range: { above: 0 },
    uniform: false,
    clears: 'texelPixels',
    techniques: WITH_MAP,
    sentence:
      'Width of a stroke on the screen, from the width that the map draws strokes at: `texelPixels` in other words. Setting one of the two clears the other. `null` leaves it to `texelPixels`.',
  },
  edgePixels: {
    kind: 'number',
    group: 'Strokes',
    default: 1,
    measure: 'gridPixels',
    range: { from: 0 },
    techniques: WITH_MAP,
    when: { crisp: [true], medium: ['ink', 'stipple'] },
    sentence:
      'Width over which ink fades at the edge of a stroke, for `anchored` and `crisp`. 0 is hard. Dry media have `softness` instead.',
  },
  anchorSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 0.45,
    measure: 'tiles',
    range: { above: 0 },
    techniques: ['anchored'],
    sentence:
      'Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter strokes.',
  },
  lineField: {
    kind: 'choice',
    group: 'Strokes',
    type: 'LineField',
    typeSentence: 'What the lines of `engraved` are cut by.',
    choices: {
      light: 'planes across the light, or spheres around a lamp: lines run around it, tangent to it.',
      towards: 'planes that hold the direction of the light: lines run towards it.',
      x: 'planes across the x axis of the object, or of the scene that `applyHatching` dressed: lines stay where they are while the light moves.',
      y: 'the same across its y axis.',
      z: 'the same across its z axis.',
    },
    default: 'light',
    techniques: ['engraved'],
    sentence: 'What the lines are cut by.',
  },
  lineSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 5,
    measure: 'tileParts',
    measureOnScreen: 'pixels',
    range: { above: 0 },
    techniques: ['engraved'],
    sentence:
      'Distance between lines, at least `finestSpacing`. As one comes nearer new ones are born between them, thin at first.',
  },
  finestSpacing: {
    kind: 'number',
    group: 'Strokes',
    default: 3,
    measure: 'pixels',
    range: { from: 2 },
    techniques: ['engraved'],
    sentence:
      'Least distance between lines. Where they would lie closer every other one is left out; fewer than three pixels from one to the next flicker in motion.',
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
    techniques: WITH_MAP,
    sentence: "How many layers of strokes there are. `secondLayer: true` is an older name of `'lights'`.",
  },
  crossFrom: {
    kind: 'number',
    group: 'Strokes',
    default: 0.52,
    range: { from: 0, to: 1 },
    techniques: [...WITH_MAP, 'engraved'],
    when: { strokeLayers: ['tone'] },
    sentence:
      "Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of `engraved`; at 1 none do.",
  },
  crossAngle: {
    kind: 'number',
    group: 'Strokes',
    default: Math.PI / 3,
    defaultSource: 'Math.PI / 3',
    measure: 'radians',
    range: { above: 0, to: Math.PI / 2 },
    uniform: false,
    techniques: [...WITH_MAP, 'engraved'],
    when: { strokeLayers: ['tone'] },
    sentence:
      "Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that cut the first lines of `engraved` and those that cut the lines across them. 60° is a pen's, 90° an engraver's.",
  },
  handmade: {
    kind: 'number',
    group: 'Strokes',
    default: 0.4,
    range: { from: 0, to: 1 },
    techniques: ['engraved'],
    sentence:
      'How unsteady the hand is: widths that differ, lines that stray, gaps in the lights. 0 is a ruling machine.',
  },
  carved: {
    kind: 'switch',
    group: 'Strokes',
    default: false,
    techniques: ['engraved'],
    sentence:
      'Lines are cut white out of black, as in a woodcut: wedges that widen with the light and end in points ([media.md](media.md)).',
  },
  creaseAngle: {
    kind: 'number',
    group: 'Strokes',
    default: Math.PI / 2,
    defaultSource: 'Math.PI / 2',
    measure: 'radians',
    range: { from: 0, to: Math.PI },
    uniform: false,
    techniques: ['adjacency'],
    sentence:
      'The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing blends. The default is the rule of the paper by Suarez et al.',
  },
  shadowStrokes: {
    kind: 'choice',
    group: 'Strokes',
    type: 'ShadowStrokes',
    typeSentence: 'What cast shadows do to the strokes.',
    choices: {
      tone: 'darken them.',
      cross:
        'lie over them as a layer of its own, across theirs, with a clean edge. The strokes of the light run on below it.',
      reorient:
        'turn them to the lights that still arrive, hard where half of a light is shadowed; where none arrives, across the light. `triangle` and `adjacency`, whose frames are made before shadows are known, turn them by a right angle where shadows take most of the light.',
    },
    default: 'tone',
    sentence: 'What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all.',
  },
  medium: {
    kind: 'choice',
    group: 'Medium',
    type: 'Medium',
    typeSentence: 'What strokes are drawn with.',
    choices: {
      ink: 'ink or paper, and nothing between.',
      dry: 'pencil, charcoal or chalk: a grey that grows with the pressure and catches on the tooth of the paper, which lies on the screen.',
      stipple:
        'dots in the place of strokes, fixed on the surface and round on the screen. `strokeWidth` is the diameter of a dot at half tone. Draws without a map.',
    },
    withoutMap: ['stipple'],
    default: 'ink',
    techniques: ['anchored'],
    sentence: 'What strokes are drawn with ([media.md](media.md)). The tone is the same with all.',
  },
  tooth: {
    kind: 'number',
    group: 'Medium',
    default: 0.4,
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence:
      'How much the tooth of the paper counts against the stroke in where a dry medium lies: at 0 strokes are smooth, at 1 there is nothing but grain.',
  },
  toothSize: {
    kind: 'number',
    group: 'Medium',
    default: 2.5,
    measure: 'pixels',
    range: { above: 0 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence: 'Size of the bumps of that tooth.',
  },
  softness: {
    kind: 'number',
    group: 'Medium',
    default: 0.6,
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence:
      'How gradually a dry medium covers: near 0 it covers or does not, as charcoal pressed hard; at 1 every tone is a grey.',
  },
  smudge: {
    kind: 'number',
    group: 'Medium',
    default: 0,
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence: 'How much of a dry medium is rubbed into plain tone below the strokes.',
  },
  toneModel: {
    kind: 'choice',
    group: 'Tone',
    type: 'ToneModel',
    typeSentence: 'How light becomes tone (paper by Suarez et al., section 3.4 and figure 9).',
    choices: {
      lambert: 'N·L.',
      halfLambert: '(N·L / 2 + 1/2)², which reaches round to the side turned away.',
      phong: 'Lambert plus a highlight (R·V)^shininess.',
      toon: 'Lambert in `toneSteps` hard bands, each of them one tone.',
      shadow:
        "the share of the light that shadows take, and nothing else: for a ground that shows the shadows on it. With `paperOpacity: 0` and `transparent`, like three's ShadowMaterial, hatched.",
    },
    default: 'lambert',
    sentence: 'How light becomes tone.',
  },
  toneSteps: {
    kind: 'number',
    group: 'Tone',
    default: 4,
    range: { from: 2 },
    when: { toneModel: ['toon'] },
    sentence: "Number of bands of the tone model `'toon'`.",
  },
  shininess: {
    kind: 'number',
    group: 'Tone',
    default: 30,
    range: { from: 0 },
    when: { toneModel: ['phong'] },
    sentence: "Exponent of the highlight of the tone model `'phong'`.",
  },
  toneNormal: {
    kind: 'choice',
    group: 'Tone',
    type: 'ToneNormal',
    typeSentence: 'The normal that tone is computed from.',
    choices: {
      face: 'the normal of the flat triangle, as in the paper by Suarez et al.',
      smooth: 'the interpolated vertex normal.',
    },
    default: 'face',
    defaultFor: ofTechniques(({ toneNormal }) => toneNormal),
    sentence:
      "The normal that tone is computed from. Reads as the one in use; `'auto'` leaves it to the technique again.",
  },
  toneCurve: {
    kind: 'curve',
    group: 'Tone',
    default: 'linear',
    sentence:
      "From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is covered where the light looks half as light as white (CIE lightness), which opens up the shade. Or 2 to 8 points `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other points need no other program.",
  },
  reflectedLight: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    range: { from: 0, to: 1 },
    sentence:
      'How much of each light the surroundings throw back: the side turned away is lit by so much from behind, so that shade is darkest at the terminator, as engravers draw it.',
  },
  occlusion: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    range: { from: 0, to: 1 },
    sentence:
      'How much ambient occlusion counts that `bakeOcclusion` has baked ([occlusion.md](occlusion.md)): cavities, folds and contacts are darker under any light. Without such a bake it does nothing.',
  },
  keepHighlight: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    range: { from: 0, to: 1 },
    uniform: false,
    sentence: 'Tone, after the tone curve, below which the paper stays blank: a highlight with an edge.',
  },
  highlightSoftness: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    range: { from: 0, to: 1 },
    uniform: false,
    sentence: 'How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `keepHighlight`.',
  },
  normalMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence:
      "Normal map, as in three's own materials (`normalMapType` says of which space). Turns the smooth tone normal; face normals stay those of the triangles.",
  },
  normalScale: {
    kind: 'vector2',
    group: 'Surface',
    default: [1, 1],
    sentence: 'How far the normal map turns the normal, along x and y.',
  },
  bumpMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence:
      'Heights that turn the smooth tone normal, where there is no normal map; face normals stay those of the triangles.',
  },
  bumpScale: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    sentence: 'How far the bump map turns the normal.',
  },
  flatShading: {
    kind: 'switch',
    group: 'Surface',
    default: false,
    sentence: 'Makes the smooth tone normal that of the flat triangle, before a normal or bump map turns it.',
  },
  aoMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Ambient occlusion (red channel): dims light without a direction, the environment and the light map.',
  },
  aoMapIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    range: { from: 0 },
    sentence: 'How much the ambient occlusion counts.',
  },
  lightMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Light baked into a map, added to that of the scene; coloured light counts by its luminance.',
  },
  lightMapIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    range: { from: 0 },
    sentence: 'How much the light map counts.',
  },
  emissive: {
    kind: 'color',
    group: 'Surface',
    default: 0x000000,
    defaultWords: 'black',
    sentence: 'Light that the surface gives off; its luminance lowers the tone.',
  },
  emissiveIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    range: { from: 0 },
    sentence: 'How strong that light is.',
  },
  emissiveMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Map of that light, multiplied by `emissive`.',
  },
  ink: {
    kind: 'color',
    group: 'Colour',
    default: 0x000000,
    defaultWords: 'black',
    sentence: 'Colour of the strokes.',
  },
  paper: {
    kind: 'color',
    group: 'Colour',
    default: 0xffffff,
    defaultWords: 'white',
    sentence: 'Colour of the ground between strokes, multiplied by the surface colour.',
  },
  color: {
    kind: 'color',
    group: 'Colour',
    default: 0xffffff,
    defaultWords: 'white',
    uniform: 'diffuse',
    sentence: 'Surface colour.',
  },
  inkBlend: {
    kind: 'choice',
    group: 'Colour',
    type: 'InkBlend',
    typeSentence: 'What ink does to the colour below it.',
    choices: {
      cover: "hides it, as gouache or a printer's black.",
      multiply: 'tints it, as transparent ink.',
    },
    default: 'cover',
    sentence: 'What ink does to the colour below it.',
  },
  paperOpacity: {
    kind: 'number',
    group: 'Colour',
    default: 1,
    range: { from: 0, to: 1 },
    sentence:
      'Below 1 one sees through the paper; at 0 there are strokes and nothing else. Needs `transparent`, `alphaTest` or `alphaHash`: a material that is drawn opaque keeps its paper.',
  },
  map: {
    kind: 'texture',
    group: 'Colour',
    default: null,
    sentence: 'Surface colour map, multiplied by `color`.',
  },
  alphaMap: {
    kind: 'texture',
    group: 'Colour',
    default: null,
    sentence: "Opacity map (green channel), as in three's own materials.",
  },
  debugView: {
    kind: 'choice',
    group: 'Checking',
    type: 'DebugView',
    typeSentence: 'What is drawn in the place of strokes.',
    choices: {
      none: 'nothing: strokes are drawn.',
      blendFactors: 'the contributions of α, β, γ as red, green, blue (figure 8).',
      tone: 'the wanted tone as grey.',
      frames: 'a checker in the stroke coordinates of the triangle itself.',
    },
    default: 'none',
    sentence: 'Draws something else in the place of strokes, to see what goes into them.',
  },
} as const satisfies Record<string, PropertyRow>;
