import { numberOf } from './materialRows.js';
import { inGroup } from './Setting.js';

const FADING = { depth: ['on'] } as const;

/** Where the drawing has weight, and where it is left out. */
export const COMPOSITION_SETTINGS = inGroup('Composition', 'scene', {
  depth: {
    kind: 'choice',
    label: 'Distance',
    partOf: 'depthFade',
    default: 'auto',
    choices: { auto: 'Fades in deep scenes', on: 'Fades', off: 'Does not fade' },
  },
  depthStrength: {
    kind: 'number',
    label: 'Fades by',
    partOf: 'depthFade',
    when: FADING,
    default: 70,
    unit: '%',
    min: 0,
    max: 100,
    step: 1,
  },
  depthNear: numberOf('depthNear', { label: 'From', when: FADING, min: 0, max: 100, ends: ['front', 'back'] }),
  depthFar: numberOf('depthFar', { label: 'Up to', when: FADING, min: 0, max: 200, ends: ['front', 'beyond'] }),
});
