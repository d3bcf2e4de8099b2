import { type HatchingMaterialParameters, type PresetName, presets } from 'three-hatching';
import type { Settings } from './settings.js';

const curveOf = (name: PresetName) => presets[name].material.toneCurve ?? 'linear';

/** The curves from light to printed tone, as the material takes them. */
export const TONE_CURVES = {
  linear: 'linear',
  perceptual: 'perceptual',
  contrast: [
    [0, 0],
    [0.25, 0.1],
    [0.75, 0.9],
    [1, 1],
  ],
  printed: curveOf('engraving'),
  cut: curveOf('woodcut'),
  rubbed: curveOf('charcoal'),
  chalked: curveOf('chalk'),
} as const satisfies Record<Settings['toneCurve'], unknown>;

/** What the page calls a curve. */
export function nameOfCurve(curve: NonNullable<HatchingMaterialParameters['toneCurve']>): Settings['toneCurve'] {
  for (const [name, known] of Object.entries(TONE_CURVES)) if (known === curve) return name as Settings['toneCurve'];
  throw new Error('nameOfCurve: the page has no name for this tone curve; give it one in TONE_CURVES.');
}
