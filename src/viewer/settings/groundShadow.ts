import type { HatchingMaterialParameters } from 'three-hatching';
import type { Settings } from './settings.js';
import { UNITS } from './table/rows.js';

/**
 * The shadow properties whose settings have the same name, in percent. On the page they belong to the ground's material and not to the
 * model's, so they are not material settings.
 */
export const SHADOW_NUMBERS = ['shadowTone', 'shadowFade', 'shadowSoftness'] as const;

type ShadowNumbers = Record<(typeof SHADOW_NUMBERS)[number], number>;

/** The shadow parameters of the ground's material. */
export const shadowNumbers = (settings: Settings): ShadowNumbers =>
  Object.fromEntries(SHADOW_NUMBERS.map((name) => [name, UNITS.share.toProperty(settings[name])])) as ShadowNumbers;

/** The settings that correspond to shadow parameters of a material. Absent parameters give no setting. */
export const settingsOfShadow = (parameters: HatchingMaterialParameters): Partial<Settings> =>
  Object.fromEntries(
    SHADOW_NUMBERS.flatMap((name) => {
      const value = parameters[name];
      return value === undefined ? [] : [[name, UNITS.share.toSetting(value)]];
    }),
  );
