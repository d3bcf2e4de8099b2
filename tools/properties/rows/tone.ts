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
    },
    default: 'lambert',
    sentence: 'How light becomes tone.',
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
    defaultFor: { perTriangle: 'face', strokes: 'smooth', lines: 'smooth' },
    sentence:
      "The normal that tone is computed from. The value in use is read back; `'auto'` leaves it to the technique again.",
  },
  toneCurve: {
    kind: 'curve',
    group: 'Tone',
    default: 'linear',
    defaultFor: { strokes: 'printed', lines: 'printed' },
    sentence:
      "From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other points need no other program.",
  },
  reflectedLight: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    defaultFor: { strokes: 0.35, lines: 0.4 },
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      'Share of each light that the surroundings throw back from behind: shade is darkest at the terminator, as engravers draw it. Planes in shade get more of it on one side of the light, so that two walls at one angle to the light differ.',
  },
  metalness: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      "How metallic the surface is, as in three's own materials. Smooth metal is drawn as draughtsmen draw chrome, by the room it mirrors: light above, dark below a horizon with a hard edge, and a floor that is light again. What does not mirror is shaded as any surface. Above 0 on smooth metal it compiles another program.",
  },
  roughness: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    when: { metalness: { not: 0 } },
    sentence:
      "How rough metal is, as in three's own materials: up to 0.4 it mirrors, from there on less, and from 0.7 on nothing.",
  },
  occlusion: {
    kind: 'number',
    group: 'Tone',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      'Strength of the ambient occlusion that `bakeOcclusion` has baked ([composition.md](composition.md#ambient-occlusion)): cavities, folds and contacts are darker under any light. Without such a bake it does nothing.',
  },
  hollowStrength: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    defaultFor: { strokes: 1, lines: 1 },
    measure: 'share',
    range: { from: 0, to: 1 },
    when: { occlusion: { not: 0 } },
    sentence:
      'How far hollows that `occlusion` knows of are brought to the darkest tone, under any light: sockets, nostrils, the parting of lips, undercuts and contacts. At 0 they only lose light.',
  },
  colorHatching: {
    kind: 'number',
    group: 'Tone',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      "How much of the darkness of the surface's own colour (`color`, `map` and vertices) is hatched: at 1 a colour that looks half as light as white (CIE lightness) brings the tone half way to the darkest. White is left as it is. Presets draw colours by it in ink alone, with a `colorFill` of 0.",
  },
  highlightThreshold: {
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
    when: { highlightThreshold: { not: 0 } },
    sentence: 'How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightThreshold`.',
  },
} as const satisfies Record<string, PropertyRow>;
