import type { Vector2 } from 'three';
import type { HatchingMaterial } from 'three-hatching';
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
  const { ink: _ink, paper: _paper, color: _color, strokeOffset, ...look } = materialLook(settings, technique);
  return (material) => {
    Object.assign(material, look);
    material.strokeOffset.copy(strokeOffset as Vector2);
    for (const name of ['ink', 'paper', 'color'] as const) material[name].set(settings[name]);
  };
}

/** Does it for one. */
export const applyToMaterial = (material: HatchingMaterial, settings: Settings): void =>
  settingsApplier(settings)(material);
