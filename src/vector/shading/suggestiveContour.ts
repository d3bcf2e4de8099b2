/** Suggestive contours, where a contour would appear if the eye moved a little, as in shaders/outlines/suggestiveContour.glsl. */
import { OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { combined, cross, dot, lengthOf, normalize, smoothstep, type Vec3 } from '../../look/vectors.js';

const { LEAST_GROWTH, FULL_GROWTH, LEAST_LEAN, FULL_LEAN } = OUTLINE_CONSTANTS;

/** A corner of a triangle. */
export interface BentCorner {
  position: Vec3;
  /** Unit. */
  normal: Vec3;
  /** Curvature along the line of sight, times the radius. */
  bend: number;
}

/**
 * The share of its weight that the outline on a triangle has, from 0 to 1.
 *
 * @param toEye from the middle of the triangle, of any length
 * @param radius of the bounding sphere, in the unit of the positions
 */
export function suggestiveShare(
  corners: readonly [BentCorner, BentCorner, BentCorner],
  toEye: Vec3,
  radius: number,
): number {
  const [a, b, c] = corners;
  const ab = combined(1, b.position, -1, a.position);
  const ac = combined(1, c.position, -1, a.position);
  const n = cross(ab, ac);
  // The gradient of the curvature, which is linear over the triangle.
  const rising = cross(n, combined(c.bend - a.bend, ab, -(b.bend - a.bend), ac));
  const gradient = combined(1 / Math.max(dot(n, n), 1e-30), rising, 0, rising);
  const normal = normalize(combined(1, combined(1, a.normal, 1, b.normal), 1, c.normal));
  const v = normalize(toEye);
  const w = combined(1, v, -dot(normal, v), normal);
  const lean = lengthOf(w);
  const growth = (radius * dot(gradient, w)) / Math.max(lean, 1e-6);
  return smoothstep(LEAST_GROWTH, FULL_GROWTH, growth * smoothstep(LEAST_LEAN, FULL_LEAN, lean));
}
