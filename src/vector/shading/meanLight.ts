import type { Sky } from '../../look/surroundings.js';
import { combined, type Vec3 } from '../../look/vectors.js';
import { arriving, type Lamp } from './radiance.js';

/** The direction from which light comes at a place in the world, for the shading of outlines: the mean of all lights, of any length. */
export function meanLightAt(place: Vec3, lamps: readonly Lamp[], skies: readonly Sky[]): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  for (const lamp of lamps) {
    const { direction, luminance } = arriving(lamp, place);
    sum = combined(1, sum, luminance, direction);
  }
  for (const { up, difference } of skies) sum = combined(1, sum, difference, up);
  return sum;
}
