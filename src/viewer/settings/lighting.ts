import { MathUtils } from 'three';
import type { Settings } from './settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight } from './settingValues.js';

/** The lights of a drawing. Intensities are those of three.js, angles are in radians. */
export interface Lighting {
  readonly kind: Settings['lightKind'];
  readonly place: LightPlace;
  readonly intensity: number;
  /** Between the axis of a spot light and the edge of its cone. */
  readonly spotAngle: number;
  /** The share of the cone of a spot light that is soft. */
  readonly spotPenumbra: number;
  readonly second: { readonly place: LightPlace; readonly intensity: number } | undefined;
  readonly castsShadows: boolean;
  /** Whether the lights stay with the viewer, and not with the model. */
  readonly isWithViewer: boolean;
}

/** At an intensity of π, a white surface that faces the light gets tone 0: bare paper. @param strength in percent of that */
const intensityOf = (strength: number): number => (Math.PI * strength) / 100;

/** The lights that settings ask for. */
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
