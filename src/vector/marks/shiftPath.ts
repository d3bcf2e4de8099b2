import { type LinePath, PATH_STRIDE } from '../paths/LinePath.js';

/**
 * Offsets a path sideways; or keeps it in place and widens one side as it narrows the other, so that it stays on its surface.
 *
 * @param beside how far each point lies beside the path, pixels: two numbers each
 */
export function shiftPath({ points, isClosed }: LinePath, beside: readonly number[], isMoved: boolean): void {
  const changed = points as number[];
  const count = points.length / PATH_STRIDE;
  // Normals are those of the path before.
  const normals = Array.from({ length: count }, (_, i) => leftOf(points, i, isClosed));
  for (let i = 0; i < count; i++) {
    const o = PATH_STRIDE * i;
    const [x, y] = [beside[2 * i], beside[2 * i + 1]];
    if (isMoved) {
      changed[o] += x;
      changed[o + 1] += y;
      continue;
    }
    const towardsLeft = x * normals[i][0] + y * normals[i][1];
    changed[o + 2] += towardsLeft;
    changed[o + 3] -= towardsLeft;
  }
}

/** The unit vector to the left of a path at a point, as in `strokeOutline`. */
function leftOf(points: readonly number[], i: number, isClosed: boolean): readonly [number, number] {
  const count = points.length / PATH_STRIDE;
  const before = PATH_STRIDE * (isClosed ? (i + count - 1) % count : Math.max(i - 1, 0));
  const after = PATH_STRIDE * (isClosed ? (i + 1) % count : Math.min(i + 1, count - 1));
  const [dx, dy] = [points[after] - points[before], points[after + 1] - points[before + 1]];
  const length = Math.hypot(dx, dy) || 1;
  return [-dy / length, dx / length];
}
