import type { Vector3 } from 'three';

/** The maximum reach of shadows, in radii of the model; those of a low light would be endless. */
const REACH = 12;

/**
 * The shadows of points on level ground. Points at or above a lamp's height cast none.
 *
 * @param points xyz of each point
 * @param light the position of a lamp, or the direction to a sun
 * @param isSun whether the light is directional
 * @param height of the ground
 * @returns xyz of each shadow
 */
export function shadowOnGround(points: ArrayLike<number>, light: Vector3, isSun: boolean, height: number): number[] {
  const shadow: number[] = [];
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    // From the light to the point.
    const [dx, dy, dz] = isSun ? [-light.x, -light.y, -light.z] : [x - light.x, y - light.y, z - light.z];
    if (dy >= 0) continue;
    const steps = Math.min((height - y) / dy, REACH / Math.hypot(dx, dz));
    shadow.push(x + steps * dx, height, z + steps * dz);
  }
  return shadow;
}
