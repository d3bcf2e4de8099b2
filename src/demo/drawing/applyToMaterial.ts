import type { HatchingMaterial } from 'three-hatching';
import { materialLook } from '../settings/materialLook.js';
import type { Settings } from '../settings/settings.js';

/**
 * Copies settings to a material; all but its sizes in pixels. One by one, because `setValues` warns of what the technique
 * does not use, and settings are kept for the next technique.
 *
 * @param technique that of the settings or, for the other side of a comparison, another
 */
export function applyToMaterial(
  material: HatchingMaterial,
  settings: Settings,
  technique: Settings['technique'] = settings.technique,
): void {
  const { ink: _ink, paper: _paper, color: _color, ...look } = materialLook(settings, technique);
  Object.assign(material, look);
  for (const name of ['ink', 'paper', 'color'] as const) material[name].set(settings[name]);
}
