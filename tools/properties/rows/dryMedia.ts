import type { PropertyRow } from '../PropertyRow.js';

const techniques = ['dryMedia'] as const;

/** The properties of dry media and their paper. */
export const DRY_MEDIA = {
  paperGrain: {
    kind: 'number',
    group: 'Dry media',
    default: 0.4,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques,
    sentence:
      'How strongly the grain of the paper breaks up strokes: at 0 strokes are smooth, at 1 only grain is left.',
  },
  paperGrainSize: {
    kind: 'number',
    group: 'Dry media',
    default: 2.5,
    measure: 'pixels',
    range: { above: 0 },
    techniques,
    sentence: 'Size of the bumps of the paper.',
  },
  softness: {
    kind: 'number',
    group: 'Dry media',
    default: 0.6,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques,
    sentence:
      'How gradually strokes cover: near 0 it is black or white, as charcoal pressed hard; at 1 every tone is a grey.',
  },
  smudge: {
    kind: 'number',
    group: 'Dry media',
    default: 0,
    measure: 'share',
    range: { from: 0, to: 1 },
    techniques,
    sentence: 'How much of the strokes is rubbed into plain tone below them.',
  },
} as const satisfies Record<string, PropertyRow>;
