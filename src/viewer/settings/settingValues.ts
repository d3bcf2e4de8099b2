import { MathUtils } from 'three';
import { counts, followsForm, formOf, type HatchingLook, needsAdjacency, needsMap } from 'three-hatching/facts';
import { materialLook } from './materialLook.js';
import type { Settings } from './settings.js';

/** Position of a light, seen from the centre of the model: azimuth and elevation in degrees, and distance in radii for lamps. */
export interface LightPlace {
  azimuth: number;
  elevation: number;
  distance?: number;
}

/** Azimuth of a second sun relative to the main light, in degrees. */
const SECOND_LIGHT_AZIMUTH = { left: -90, right: 90, opposite: 180 } as const;

export function placeOfLight(settings: Settings): LightPlace {
  const { lightAzimuth: azimuth, lightElevation: elevation, lightDistance: distance } = settings;
  return settings.lightKind === 'directional' ? { azimuth, elevation } : { azimuth, elevation, distance };
}

/** The position of the second sun, or undefined if there is none. */
export function placeOfSecondLight(settings: Settings): LightPlace | undefined {
  const { secondLight, lightAzimuth, lightElevation, secondAzimuth, secondElevation } = settings;
  if (secondLight === 'none') return undefined;
  if (secondLight === 'free') return { azimuth: secondAzimuth, elevation: secondElevation };
  const azimuth = lightAzimuth + SECOND_LIGHT_AZIMUTH[secondLight];
  return { azimuth: MathUtils.euclideanModulo(azimuth + 180, 360) - 180, elevation: lightElevation };
}

/** The looks that the page draws: one, or two in a comparison. */
export function looksOf(settings: Settings): HatchingLook[] {
  const { technique, compare } = settings;
  return [technique, compare].flatMap((shown) => (shown === 'none' ? [] : [materialLook(settings, shown)]));
}

/** Whether a look, on either side of a comparison, draws with a tonal art map. */
export const drawsWithMap = (settings: Settings): boolean => looksOf(settings).some(needsMap);

/** Whether a look needs triangle adjacency. */
export const drawsWithAdjacency = (settings: Settings): boolean => looksOf(settings).some(needsAdjacency);

/** How form lines are baked, and whether lines whose crossing angle is baked are drawn; undefined if nothing follows the form. */
export function formDrawn(settings: Settings): { auto: boolean; hasLines: boolean } | undefined {
  const looks = looksOf(settings).filter(followsForm);
  if (looks.length === 0) return undefined;
  return {
    auto: looks.every((look) => formOf(look) === 'auto'),
    hasLines: looks.some((look) => counts(look, 'lineField')),
  };
}

/** The file format of a saved picture: PNG, or ZIP with one PNG per layer. */
export const savedFormat = ({ pictureLayers }: Settings): 'PNG' | 'ZIP' => (pictureLayers === 'one' ? 'PNG' : 'ZIP');

/** Rotations about x, y and z that turn each up axis to +y. */
export const UPRIGHT: Readonly<Record<Settings['upAxis'], [number, number, number]>> = {
  y: [0, 0, 0],
  z: [-Math.PI / 2, 0, 0],
  x: [0, 0, Math.PI / 2],
  '-y': [0, 0, Math.PI],
  '-z': [Math.PI / 2, 0, 0],
  '-x': [0, 0, -Math.PI / 2],
};
