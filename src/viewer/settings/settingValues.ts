import { MathUtils } from 'three';
import type { HatchingTechnique } from 'three-hatching';
import {
  counts,
  drawsLines,
  followsForm,
  formOf,
  HATCHING_FACTS,
  HATCHING_PROPERTIES,
  type HatchingLook,
  knowsChoice,
  measureOf,
  needsAdjacency,
  needsMap,
} from 'three-hatching/facts';
import { materialLook } from './materialLook.js';
import { SETTINGS, type SettingKey, type Settings } from './settings.js';
import { type Setting, UNITS } from './table/rows.js';

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
    hasLines: looks.some(({ technique }) => drawsLines(technique as HatchingTechnique)),
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

/**
 * Whether a setting changes the drawing or the saved file.
 *
 * @param looks that are drawn
 */
export function hasEffect(
  key: SettingKey,
  settings: Settings,
  looks: readonly HatchingLook[] = looksOf(settings),
): boolean {
  const { when = {} }: Setting = SETTINGS[key];
  return (
    Object.entries(when).every(([other, values]) => values.includes(String(settings[other as SettingKey]))) &&
    looks.some((look) => countsFor(look, key))
  );
}

/** Whether a setting has an effect in one look, according to the library's table of properties. */
function countsFor(look: HatchingLook, key: SettingKey): boolean {
  const { property, partOf = property, isForStrokes }: Setting = SETTINGS[key];
  if (isForStrokes && drawsLines(look.technique as HatchingTechnique)) return false;
  return partOf === undefined || counts(look, partOf);
}

/** Whether one of the looks' techniques supports a choice. */
export function isChoiceKnown(key: SettingKey, value: string, looks: readonly HatchingLook[]): boolean {
  const { property }: Setting = SETTINGS[key];
  if (property === undefined) return true;
  const row = HATCHING_PROPERTIES[property];
  return looks.some(({ technique }) => knowsChoice(technique as HatchingTechnique, row, value));
}

/** The unit of a setting's number in the present look; none where the property is a weighted mean of two units. */
export function presentUnit(key: SettingKey, [look]: readonly HatchingLook[]): string {
  const setting: Setting = SETTINGS[key];
  if (setting.kind !== 'number') return '';
  const { property, unit } = setting;
  if (property === undefined || !HATCHING_FACTS[property]?.measureOnScreen) return unit;
  const measure = measureOf(look, property);
  return measure ? UNITS[measure].name : '';
}

/** Whether a setting decides which tonal art map is drawn, or whether one is. */
export function choosesMap(key: SettingKey): boolean {
  const { property, partOf = property }: Setting = SETTINGS[key];
  return key === 'compare' || partOf === 'tonalArtMap' || partOf === 'technique';
}
