import type { HatchingMaterialParameters } from 'three-hatching';
import type { Settings } from './settings.js';
import { UNITS } from './table/units.js';

/**
 * The properties of a shadow on the ground that are settings of the same name, in percent. They are no twins of the material's: on the
 * page they belong to the ground, and the material of the model does not show them.
 */
export const SHADOW_NUMBERS = ['shadowTone', 'shadowFade', 'shadowSoftness'] as const;

type ShadowNumbers = Record<(typeof SHADOW_NUMBERS)[number], number>;

/** What the material of the ground takes, from the settings. */
export const shadowNumbers = (settings: Settings): ShadowNumbers =>
  Object.fromEntries(SHADOW_NUMBERS.map((name) => [name, UNITS.share.toProperty(settings[name])])) as ShadowNumbers;

/** The settings that give the ground's material these parameters. Others stay as they are. */
export const settingsOfShadow = (parameters: HatchingMaterialParameters): Partial<Settings> =>
  Object.fromEntries(
    SHADOW_NUMBERS.flatMap((name) => {
      const value = parameters[name];
      return value === undefined ? [] : [[name, UNITS.share.toSetting(value)]];
    }),
  );
