import { combined, dot, type Vec3 } from '../../look/vectors.js';
import type { Projection } from '../Projection.js';

/** The ways in the plane through a place that lead one pixel to the right and one up on the picture; null where it is seen edge-on. */
export function pixelSteps(world: Vec3, normal: Vec3, projection: Projection): readonly [Vec3, Vec3] | null {
  const [x, y] = projection.project(...projection.toView(world));
  const wayTo = (px: number, py: number): Vec3 | null => {
    const { origin, direction } = projection.rayThrough(px, py);
    const t = dot(combined(1, world, -1, origin), normal) / dot(direction, normal);
    return Number.isFinite(t) ? combined(1, combined(1, origin, t, direction), -1, world) : null;
  };
  const [right, up] = [wayTo(x + 1, y), wayTo(x, y - 1)];
  return right && up && [right, up];
}
