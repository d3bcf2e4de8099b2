import { LINES_FAMILY, STROKES_FAMILY } from '../ofTechniques.js';
import type { PropertyRow } from '../PropertyRow.js';

/** The techniques that draw with a plan of what matters; those of the paper by Suarez et al. draw all alike. */
const techniques = [...STROKES_FAMILY, ...LINES_FAMILY];

/** The properties of composition: where the drawing has weight, and where it is left out. */
export const COMPOSITION = {
  exposure: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 1,
    measure: 'factor',
    range: { above: 0 },
    words: ['fit', 'auto'],
    uniform: false,
    sentence:
      "What the light is multiplied by before it becomes tone. `'fit'` fits it to the lights and surfaces of the scene in the first frame, so that lights, half tones and darks are those of a sphere in a single light of intensity π, and keeps it until `refit()`: a part that is hidden, added or coloured changes no other part. `'auto'` fits it again whenever lights or surfaces change. For a material with a `toneCurve` of points that no preset has, both are 1 ([lights-and-tone.md](lights-and-tone.md#exposure)).",
  },
  exposureCompensation: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 1,
    measure: 'factor',
    range: { above: 0 },
    uniform: false,
    when: { exposure: ['fit', 'auto'] },
    sentence: 'What the fitted exposure is multiplied by: above 1 for a lighter picture, below for a darker one.',
  },
  plannedValues: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    uniform: false,
    when: { exposure: ['fit', 'auto'] },
    sentence:
      'How far the colours that `colorHatching` draws get their darkness from a plan of values of the scene, made with the fitted exposure: by rank, the lighter half of what is seen stays blank, and only the darkest is dark, so that light and shade are still read; details of maps that are finer than four spacings of lines are left out. At 0 each colour is as dark as it is measured ([lights-and-tone.md](lights-and-tone.md#a-plan-of-values)).',
  },
  depthFade: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 'auto',
    measure: 'share',
    range: { from: 0, to: 1 },
    uniform: false,
    techniques,
    sentence:
      "How much lines, strokes, outlines and colours fade towards the paper with their distance, as in air: those behind are thinner and lighter, and outlines in front heavier than without. At 1 nothing is left at `depthFadeEnd`. `'auto'`: 0.7 in scenes that `applyHatching` hatched, where what is seen is more than three times as deep as the sheet's shorter side at its middle, such as streets and interiors; 0 elsewhere ([composition.md](composition.md)).",
  },
  depthFadeStart: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 0,
    measure: 'depths',
    uniform: false,
    techniques,
    when: { depthFade: { not: 0 } },
    sentence: 'Where fading begins: 0 is the nearest place of the scene that is seen, 1 the farthest.',
  },
  depthFadeEnd: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 1,
    measure: 'depths',
    uniform: false,
    techniques,
    when: { depthFade: { not: 0 } },
    sentence: 'Where fading ends, in the same units.',
  },
  focus: {
    kind: 'point',
    group: 'Composition',
    owner: 'composition',
    default: null,
    measure: 'worldUnits',
    techniques,
    sentence:
      'Point of the scene around which all is drawn. Beyond `focusRadius` tone, lines and outlines fall off, with an uneven edge, until only paper is left. `null`: all is drawn everywhere.',
  },
  focusRadius: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 1,
    measure: 'worldUnits',
    range: { above: 0 },
    uniform: false,
    techniques,
    when: { focus: { not: null } },
    sentence: 'How far around `focus` all is drawn. At two and a half times this distance nothing is left.',
  },
  vignette: {
    kind: 'number',
    group: 'Composition',
    owner: 'composition',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    uniform: false,
    techniques,
    sentence:
      'How much the drawing falls off towards the rim of the sheet, in an oval: at 1 nothing is left at the middle of each side.',
  },
} as const satisfies Record<string, PropertyRow>;
