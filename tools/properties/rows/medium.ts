import type { PropertyRow } from '../PropertyRow.js';

/** The properties of the medium and its paper. */
export const MEDIUM = {
  medium: {
    kind: 'choice',
    group: 'Medium',
    type: 'Medium',
    typeSentence: 'What strokes are drawn with.',
    choices: {
      ink: 'ink or paper, and nothing between.',
      dry: 'pencil, charcoal or chalk: a grey that grows with the pressure and catches on the tooth of the paper, which lies on the screen.',
      stipple:
        'dots in the place of strokes, fixed on the surface and round on the screen. `strokeWidth` is the diameter of a dot at half tone; from a tone of 0.95 on they leave no paper. Draws without a map.',
      pen: 'lines in strokes, which begin and end thin, and are fewer in the lights.',
      woodcut: 'lines that are cut white out of black: wedges that widen with the light and end in points.',
    },
    default: 'ink',
    choicesFor: { anchored: ['ink', 'dry', 'stipple'], engraved: ['ink', 'pen', 'woodcut'] },
    techniques: ['anchored', 'engraved'],
    sentence:
      "What strokes are drawn with ([media.md](media.md)). The tone is the same with all. `'dry'` and `'stipple'` are for `anchored`, `'pen'` and `'woodcut'` are for `engraved`; a technique draws in ink with what is not for it.",
  },
  paperGrain: {
    kind: 'number',
    group: 'Medium',
    default: 0.4,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence:
      'How strongly the tooth of the paper breaks up the strokes of a dry medium: at 0 strokes are smooth, at 1 only grain is left.',
  },
  paperGrainSize: {
    kind: 'number',
    group: 'Medium',
    default: 2.5,
    measure: 'pixels',
    range: { above: 0 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence: 'Size of the bumps of the paper.',
  },
  softness: {
    kind: 'number',
    group: 'Medium',
    default: 0.6,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence:
      'How gradually a dry medium covers: near 0 it is black or white, as charcoal pressed hard; at 1 every tone is a grey.',
  },
  smudge: {
    kind: 'number',
    group: 'Medium',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques: ['anchored'],
    when: { medium: ['dry'] },
    sentence: 'How much of a dry medium is rubbed into plain tone below the strokes.',
  },
} as const satisfies Record<string, PropertyRow>;
