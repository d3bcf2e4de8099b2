import type { Settings } from '../../viewer/settings/settings.js';
import type { LightPlace } from '../../viewer/settings/settingValues.js';
import { round } from './round.js';

/** The intensity of a light, from its strength in percent. */
export const intensityOf = (percent: number): number => round((Math.PI * percent) / 100);

/** Code that makes the main light, and the class of three.js that it needs. */
export function mainLight({ lightKind, lightStrength, spotAngle, spotSoftness }: Settings): {
  made: string;
  name: string;
} {
  const [name, more] = {
    directional: ['DirectionalLight', ''],
    point: ['PointLight', ', 0, 0'],
    spot: ['SpotLight', `, 0, ${round((spotAngle * Math.PI) / 360)}, ${spotSoftness / 100}, 0`],
  }[lightKind];
  return { name, made: `new ${name}('white', ${intensityOf(lightStrength)}${more})` };
}

/** Code that sets a position. */
export const positionOf = ({ azimuth, elevation }: LightPlace, distance: number): string =>
  `setFromSphericalCoords(${[distance, ((90 - elevation) * Math.PI) / 180, (azimuth * Math.PI) / 180].map(round).join(', ')})`;
