import { LINES_FAMILY } from '../ofTechniques.js';
import type { PropertyRow } from '../PropertyRow.js';

/** The properties that `HatchingShadowMaterial` has beside those of `HatchingMaterial`. */
export const SHADOW = {
  shadowTone: {
    kind: 'number',
    group: 'Shadows on a ground',
    owner: 'shadowMaterial',
    default: 1,
    defaultFor: { strokes: 0.5, lines: 0.5 },
    measure: 'tone',
    range: { from: 0, to: 1 },
    sentence:
      'How dark a full shadow is printed where it touches what casts it, as a factor on the tone after the tone curve. At one half a shadow on the ground is lighter than the darks of the body.',
  },
  shadowFade: {
    kind: 'number',
    group: 'Shadows on a ground',
    owner: 'shadowMaterial',
    default: 0,
    defaultFor: { strokes: 0.65, lines: 0.65 },
    measure: 'factor',
    range: { from: 0 },
    sentence:
      "How fast a shadow dissolves with the distance, along the light, from what casts it: the share of its tone that it loses over the width that the light's shadow camera sees. 0: it does not dissolve; 1: nothing is left at a distance of one width; 2: at half of one ([shadows.md](shadows.md)).",
  },
  shadowSoftness: {
    kind: 'number',
    group: 'Shadows on a ground',
    owner: 'shadowMaterial',
    default: 0,
    defaultFor: { strokes: 0.12, lines: 0.12 },
    measure: 'factor',
    range: { from: 0 },
    sentence:
      "How wide the edges of shadows are, as a share of the distance to what casts them: the width of a round lamp as a share of its own distance. At 0 all edges are as wide as the light's `shadow.radius` says.",
  },
  shadowDirection: {
    kind: 'choice',
    group: 'Shadows on a ground',
    owner: 'shadowMaterial',
    type: 'ShadowDirection',
    typeSentence: 'Which way the strokes of shadows on a ground run.',
    choices: {
      away: 'in one layer, away from the light: a long stroke thins out along the shadow and ends with it.',
      strokes: 'as those of any other surface, by all the properties of strokes.',
    },
    default: 'strokes',
    defaultFor: { perTriangle: 'strokes', strokes: 'away', lines: 'away' },
    sentence: "Which way the strokes of shadows on a ground run. `'auto'` leaves it to the technique again.",
  },
  shadowSpacing: {
    kind: 'number',
    group: 'Shadows on a ground',
    owner: 'shadowMaterial',
    default: 1.4,
    measure: 'factor',
    range: { above: 0 },
    techniques: LINES_FAMILY,
    sentence:
      'How many times as far apart as `lineSpacing` the lines of shadows are, so that a shadow on the ground is calmer than the body.',
  },
} as const satisfies Record<string, PropertyRow>;
