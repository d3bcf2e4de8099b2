import { type Color, type ColorRepresentation, Vector2 } from 'three';
import { HATCHING_PROPERTIES, type HatchingMaterial, type HatchingPropertyName } from 'three-hatching';
import { materialLook } from '../settings/materialLook.js';
import type { Settings } from '../settings/settings.js';

/**
 * Copies settings to materials; all but their sizes in pixels. One by one, because `setValues` warns of what the technique does not
 * use, and settings are kept for the next technique.
 *
 * @param technique that of the settings or, for the other side of a comparison, another
 * @returns what does it for a material; the look is worked out once for all
 */
export function settingsApplier(
  settings: Settings,
  technique: Settings['technique'] = settings.technique,
): (material: HatchingMaterial) => void {
  const look = Object.entries(materialLook(settings, technique)) as [HatchingPropertyName, unknown][];
  const colors = look.filter(([name]) => HATCHING_PROPERTIES[name].kind === 'color');
  const vectors = look.filter(([, value]) => value instanceof Vector2);
  const others = Object.fromEntries(look.filter((entry) => !colors.includes(entry) && !vectors.includes(entry)));
  return (material) => {
    Object.assign(material, others);
    for (const [name, value] of vectors) (material[name] as Vector2).copy(value as Vector2);
    for (const [name, value] of colors) (material[name] as Color).set(value as ColorRepresentation);
  };
}

/** Does it for one. */
export const applyToMaterial = (material: HatchingMaterial, settings: Settings): void =>
  settingsApplier(settings)(material);
