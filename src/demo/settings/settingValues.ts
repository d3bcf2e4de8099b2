import type { Settings } from './settings.js';

/** Azimuth of the second sun, in degrees from the light. */
export const SECOND_LIGHT_AZIMUTH = { left: -90, right: 90, opposite: 180 } as const;

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
} as const satisfies Record<Settings['toneCurve'], unknown>;

/** Whether a technique draws strokes of a set width in pure ink, instead of blending their greys. */
export function isCrisp(technique: Settings['technique']): boolean {
  return technique === 'anchored' || technique === 'adjacencyCrisp';
}

/**
 * A hand that strays by more than this many pixels also runs on past corners, by so many pixels more for each. A lighter one
 * does not, because creases of scans have corners everywhere, and lines would stand out from them like thorns.
 */
const LIGHT_HAND = 1;
const OVERSHOOT = 3;
/** Weight that lines lose in full light and gain in full shade, if the shade weight is 100 %. */
const LOST_IN_LIGHT = 1;
const GAINED_IN_SHADE = 0.8;

/**
 * What the material of lines takes, from the settings.
 *
 * @param pixelRatio pixels of the picture per CSS pixel
 */
export function lineLook(settings: Settings, pixelRatio: number) {
  const shade = settings.lineShade / 100;
  const creases = settings.lineCreases / 100;
  return {
    lineWidth: settings.lineWidth * pixelRatio,
    contours: settings.lineContours / 100,
    borders: settings.lineBorders / 100,
    creases,
    materialBorders: creases,
    suggestiveContours: settings.lineSuggestive / 100,
    shadeWeights: [1 - LOST_IN_LIGHT * shade, 1 + GAINED_IN_SHADE * shade] as const,
    wobble: settings.lineHand * pixelRatio,
    overshoot: OVERSHOOT * Math.max(0, settings.lineHand - LIGHT_HAND) * pixelRatio,
    ink: settings.ink,
  };
}
