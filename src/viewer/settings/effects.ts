import type { HatchingTechnique } from 'three-hatching';
import {
  counts,
  HATCHING_FACTS,
  HATCHING_PROPERTIES,
  type HatchingLook,
  knowsChoice,
  measureOf,
} from 'three-hatching/facts';
import { SETTINGS, type SettingKey, type Settings } from './settings.js';
import { looksOf } from './settingValues.js';
import { type Setting, UNITS } from './table/rows.js';

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
  const { property, partOf = property, yieldsTo }: Setting = SETTINGS[key];
  if (yieldsTo && counts(look, yieldsTo)) return false;
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

/** The properties that decide whether a tonal art map is drawn. */
const DECIDING = ['technique', ...[HATCHING_FACTS.tonalArtMap?.when ?? {}].flat().flatMap(Object.keys)];

/** Whether a setting decides which tonal art map is drawn, or whether one is. */
export function choosesMap(key: SettingKey): boolean {
  const { property, partOf = property }: Setting = SETTINGS[key];
  return key === 'compare' || partOf === 'tonalArtMap' || DECIDING.includes(partOf ?? '');
}
