import type { Settings } from './settings.js';

/**
 * Applies the controls Boldness and Density to the settings that they scale. Bolder strokes are wider and farther apart, so that coverage
 * stays the same; density changes coverage as the strength of the light would.
 */
export function withBoldnessAndDensity(settings: Settings): Settings {
  const size = settings.boldness / 100;
  const cover = settings.density / 100;
  if (size === 1 && cover === 1) return settings;
  return {
    ...settings,
    strokeWidth: settings.strokeWidth * size,
    lineSpacing: settings.lineSpacing * size,
    outlineWidth: settings.outlineWidth * size,
    tilesPerUnit: settings.tilesPerUnit / size,
    lightStrength: settings.lightStrength / cover,
    secondStrength: settings.secondStrength / cover,
  };
}
