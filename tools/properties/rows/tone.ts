import { ofTechniques } from '../ofTechniques.js';
import type { PropertyRow } from '../PropertyRow.js';

/** The properties of tone: how dark strokes and lights make the surface. */
export const TONE = {
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
  shadowTone: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    defaultFor: { anchored: 0.5, engraved: 0.5 },
    measure: 'tone',
    range: { from: 0, to: 1 },
    when: { toneModel: ['shadow'] },
    sentence:
      "How dark the tone model `'shadow'` prints a full shadow where it touches what casts it, as a factor on the tone after the tone curve. At one half a shadow on the ground is lighter than the darks of the body.",
  },
  shadowFade: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    defaultFor: { anchored: 1, engraved: 1 },
    measure: 'factor',
    range: { from: 0 },
    when: { toneModel: ['shadow'] },
    sentence:
      "How fast a shadow of the tone model `'shadow'` dissolves with the distance, along the light, from what casts it: the share of its tone that it loses over the width that the light's shadow camera sees. 0: it does not dissolve; 1: nothing is left at a distance of one width; 2: at half of one ([shadows.md](shadows.md)).",
  },
  shadowDirection: {
    kind: 'choice',
    group: 'Tone',
    type: 'ShadowDirection',
    typeSentence: "Which way the strokes of the tone model `'shadow'` run.",
    choices: {
      away: 'in one layer, away from the light: a long stroke thins out along the shadow and ends with it.',
      strokes: 'as those of any other surface, by all the properties of strokes.',
    },
    default: 'strokes',
    defaultFor: ofTechniques(({ vertexData }) => (vertexData === 'hatchNormal' ? 'away' : 'strokes')),
    when: { toneModel: ['shadow'] },
    sentence: "Which way the strokes of the tone model `'shadow'` run. `'auto'` leaves it to the technique again.",
  },
  shadowSpacing: {
    kind: 'number',
    group: 'Tone',
    default: 1.4,
    measure: 'factor',
    range: { above: 0 },
    techniques: ['engraved'],
    when: { toneModel: ['shadow'] },
    sentence:
      "How many times as far apart as `lineSpacing` the lines of the tone model `'shadow'` are, so that a shadow on the ground is calmer than the body.",
  },
  toneSteps: {
    kind: 'number',
    group: 'Tone',
    default: 4,
    measure: 'count',
    range: { from: 2 },
    when: { toneModel: ['toon'] },
    sentence: "Number of bands of the tone model `'toon'`.",
  },
  shininess: {
    kind: 'number',
    group: 'Tone',
    default: 30,
    measure: 'exponent',
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
  exposure: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    measure: 'factor',
    range: { above: 0 },
    isAuto: true,
    uniform: false,
    when: { toneModel: ['lambert', 'halfLambert', 'phong', 'toon'] },
    sentence:
      "What the light is multiplied by before it becomes tone. `'auto'` fits it to the lights and surfaces of the scene, so that lights, half tones and darks are those of a sphere in a single light of intensity π; it stays the same while only the camera moves. With a `toneCurve` of points that no preset has, `'auto'` is 1 ([lights-and-tone.md](lights-and-tone.md#exposure)).",
  },
  exposureCompensation: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    measure: 'factor',
    range: { above: 0 },
    uniform: false,
    when: { exposure: ['auto'], toneModel: ['lambert', 'halfLambert', 'phong', 'toon'] },
    sentence: 'What the fitted exposure is multiplied by: above 1 for a lighter picture, below for a darker one.',
  },
  toneCurve: {
    kind: 'curve',
    group: 'Tone',
    default: 'linear',
    defaultFor: { anchored: 'printed', engraved: 'printed' },
    sentence:
      "From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other points need no other program.",
  },
  reflectedLight: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    defaultFor: { anchored: 0.35, engraved: 0.4 },
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      'How much of each light the surroundings throw back: the side turned away is lit by so much from behind, so that shade is darkest at the terminator, as engravers draw it.',
  },
  occlusion: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      'How much ambient occlusion counts that `bakeOcclusion` has baked ([occlusion.md](occlusion.md)): cavities, folds and contacts are darker under any light. Without such a bake it does nothing.',
  },
  hollowTone: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    defaultFor: { anchored: 1, engraved: 1 },
    measure: 'share',
    range: { from: 0, to: 1 },
    when: { occlusion: { not: 0 } },
    sentence:
      'How far the depths of hollows that `occlusion` knows of are brought to the darkest tone, whatever light falls into them: sockets, nostrils, the parting of lips, undercuts and contacts are then the darkest places of the picture. 0: they lose light and nothing else.',
  },
  localTone: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      "How much of the darkness of the surface's own colour, be it of `color`, `map` or the vertices, is hatched: at 1 a colour that looks half as light as white (CIE lightness) brings the tone half way to the darkest. White is left as it is. Presets draw colours by it in ink alone, with a `colorFill` of 0.",
  },
  highlightTone: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    measure: 'tone',
    range: { from: 0, to: 1 },
    uniform: false,
    sentence: 'Tone, after the tone curve, below which the paper stays blank: a highlight with an edge.',
  },
  highlightSoftness: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    uniform: false,
    when: { highlightTone: { not: 0 } },
    sentence: 'How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightTone`.',
  },
} as const satisfies Record<string, PropertyRow>;
