import { MathUtils } from 'three';
import type { Settings } from './settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight } from './settingValues.js';

/** The lights of a drawing. Intensities are in three.js's units, angles in radians. */
export interface Lighting {
  readonly kind: Settings['lightKind'];
  readonly place: LightPlace;
  readonly intensity: number;
  /** Angle between the axis of a spot light and the edge of its cone. */
  readonly spotAngle: number;
  /** The soft share of a spot light's cone (three.js's `penumbra`). */
  readonly spotPenumbra: number;
  readonly second: { readonly place: LightPlace; readonly intensity: number } | undefined;
  readonly castsShadows: boolean;
  /** Whether the lights move with the viewer instead of staying with the model. */
  readonly isWithViewer: boolean;
}

/**
 * At an intensity of π, a white surface that faces the light has tone 0: bare paper.
 *
 * @param strength percent of that intensity
 */
const intensityOf = (strength: number): number => (Math.PI * strength) / 100;

/** The lights for some settings. */
export function lightingOf(settings: Settings): Lighting {
  const second = placeOfSecondLight(settings);
  return {
    kind: settings.lightKind,
    place: placeOfLight(settings),
    intensity: intensityOf(settings.lightStrength),
    spotAngle: MathUtils.degToRad(settings.spotAngle) / 2,
    spotPenumbra: settings.spotSoftness / 100,
    second: second && { place: second, intensity: intensityOf(settings.secondStrength) },
    castsShadows: settings.shadows === 'on',
    isWithViewer: settings.lightFollows === 'viewer',
  };
}
