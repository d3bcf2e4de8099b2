import type { PropertyRow } from '../PropertyRow.js';

/** The properties that show what goes into the strokes. */
export const CHECKING = {
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
