import { type PresetName, presets } from 'three-hatching';
import type { Settings } from './settings.js';

/** Azimuth of the second sun, in degrees from the light. */
export const SECOND_LIGHT_AZIMUTH = { left: -90, right: 90, opposite: 180 } as const;

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
} as const satisfies Record<Settings['toneCurve'], unknown>;

/** Whether a technique draws strokes of a set width in pure ink, instead of blending their greys. */
export function isCrisp(technique: Settings['technique']): boolean {
  return technique === 'anchored' || technique === 'adjacencyCrisp';
}
