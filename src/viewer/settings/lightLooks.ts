import type { Settings } from './settings.js';

/** Lighting presets that illustrators use, by label. The lights move with the viewer. */
export const LIGHT_LOOKS: Readonly<Record<string, Partial<Settings>>> = {
  'From the upper left, as in plates': lookOf(-45, 45),
  'Raking from the side': lookOf(-78, 12),
  'From behind': lookOf(-150, 35),
  'From below': lookOf(-20, -50),
  'From two sides': { ...lookOf(-55, 30), secondLight: 'right', secondStrength: 60 },
};

function lookOf(lightAzimuth: number, lightElevation: number): Partial<Settings> {
  return { lightFollows: 'viewer', lightAzimuth, lightElevation, secondLight: 'none' };
}
