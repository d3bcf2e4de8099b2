import { MathUtils } from 'three';
import { counts, followsForm, formOf, type HatchingLook, needsAdjacency, needsMap } from 'three-hatching/facts';
import { materialLook } from './materialLook.js';
import type { Settings } from './settings.js';

/** Where a light is, seen from the centre of the model: degrees around it, degrees high, and radii away if it is no sun. */
export interface LightPlace {
  azimuth: number;
  elevation: number;
  distance?: number;
}

/** Azimuth of a second sun that goes with the light, in degrees from it. */
const SECOND_LIGHT_AZIMUTH = { left: -90, right: 90, opposite: 180 } as const;

export function placeOfLight(settings: Settings): LightPlace {
  const { lightAzimuth: azimuth, lightElevation: elevation, lightDistance: distance } = settings;
  return settings.lightKind === 'directional' ? { azimuth, elevation } : { azimuth, elevation, distance };
}

/** Where the second sun is, or undefined if there is none. */
export function placeOfSecondLight(settings: Settings): LightPlace | undefined {
  const { secondLight, lightAzimuth, lightElevation, secondAzimuth, secondElevation } = settings;
  if (secondLight === 'none') return undefined;
  if (secondLight === 'free') return { azimuth: secondAzimuth, elevation: secondElevation };
  const azimuth = lightAzimuth + SECOND_LIGHT_AZIMUTH[secondLight];
  return { azimuth: MathUtils.euclideanModulo(azimuth + 180, 360) - 180, elevation: lightElevation };
}

/** The looks that the page draws: of its technique and, where another is compared with it, of that. */
export function looksOf(settings: Settings): HatchingLook[] {
  const { technique, compare } = settings;
  return [technique, compare].flatMap((shown) => (shown === 'none' ? [] : [materialLook(settings, shown)]));
}

/** Whether anything is drawn with a tonal art map, on either side of a comparison. */
export const drawsWithMap = (settings: Settings): boolean => looksOf(settings).some(needsMap);

/** Whether anything is drawn that asks for a prepared geometry. */
export const drawsWithAdjacency = (settings: Settings): boolean => looksOf(settings).some(needsAdjacency);

/** What is drawn that follows the form: how it is to be baked, and whether lines are among it, which cross as they were baked. */
export function formDrawn(settings: Settings): { auto: boolean; hasLines: boolean } | undefined {
  const looks = looksOf(settings).filter(followsForm);
  if (looks.length === 0) return undefined;
  return {
    auto: looks.every((look) => formOf(look) === 'auto'),
    hasLines: looks.some((look) => counts(look, 'lineField')),
  };
}

/** What a picture is saved as: alone, or in layers. */
export const savedFormat = ({ pictureLayers }: Settings): 'PNG' | 'ZIP' => (pictureLayers === 'one' ? 'PNG' : 'ZIP');

/** Rotations about x, y and z that turn an axis of the model to the top. */
export const UPRIGHT: Readonly<Record<Settings['upAxis'], [number, number, number]>> = {
  y: [0, 0, 0],
  z: [-Math.PI / 2, 0, 0],
  x: [0, 0, Math.PI / 2],
  '-y': [0, 0, Math.PI],
  '-z': [Math.PI / 2, 0, 0],
  '-x': [0, 0, -Math.PI / 2],
};
