import type { Settings } from './settings.js';

/**
 * The settings as they are drawn: with the pair of controls, fine to bold and sparse to dense, worked into those that it scales.
 * Bold strokes are wider and farther apart, so that they cover as much; dense ones cover more, as in less light.
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
