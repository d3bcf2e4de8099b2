import { numberOf } from './materialRows.js';
import { inGroup, type NumberRow } from './Setting.js';

const FADING = { depth: ['on'] } as const;
const FOCUSED = { focus: ['on'] } as const;
const BACKED = { background: ['on'] } as const;

/** A slider for one coordinate of the focus, relative to the middle of the model. */
const coordinate = (label: string, fallback: number): NumberRow & { owner: 'subject' } => ({
  kind: 'number',
  label,
  owner: 'subject',
  partOf: 'focus',
  when: FOCUSED,
  default: fallback,
  unit: 'radii',
  min: -1.5,
  max: 1.5,
  step: 0.01,
});

/** Where the drawing fades. */
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
  focus: {
    kind: 'choice',
    label: 'Focus',
    owner: 'subject',
    partOf: 'focus',
    default: 'none',
    choices: { none: 'Everywhere', on: 'On a place' },
  },
  focusX: coordinate('Focus, x', 0),
  focusY: coordinate('Focus, y', 0.2),
  focusZ: coordinate('Focus, z', 0.4),
  focusRadius: numberOf('focusRadius', {
    label: 'Focus, radius',
    owner: 'subject',
    when: FOCUSED,
    default: 0.5,
    min: 0.05,
    max: 2,
  }),
  vignette: numberOf('vignette', { label: 'Vignette', step: 5, ends: ['none', 'blank rim'] }),
  background: {
    kind: 'choice',
    label: 'Background',
    default: 'none',
    choices: { none: 'None', on: 'Hatched' },
  },
  backgroundTone: {
    kind: 'number',
    label: 'Background tone',
    when: BACKED,
    default: 25,
    unit: '%',
    min: 0,
    max: 60,
    step: 1,
  },
  backgroundSpacing: {
    kind: 'number',
    label: 'Background spacing',
    when: BACKED,
    default: 6,
    unit: 'px',
    min: 2,
    max: 20,
    step: 0.1,
  },
  backgroundDirection: {
    kind: 'number',
    label: 'Background direction',
    when: BACKED,
    default: 36,
    unit: '°',
    min: -90,
    max: 90,
    step: 1,
  },
  backgroundExtent: {
    kind: 'number',
    label: 'Background reach',
    when: BACKED,
    default: 140,
    unit: '%',
    min: 100,
    max: 300,
    step: 5,
  },
});
