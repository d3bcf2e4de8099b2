import { combined, cross, dot, normalize, timesVector, type Vec3 } from '../../look/vectors.js';
import type { Mat3 } from '../shading/screenGradient.js';
import type { Rgba } from './MapSampler.js';

/** Normal and bump maps, as in three.js. Everything is in world space. */

/** The vector that a pixel of a normal map encodes. */
export const unpacked = ([r, g, b]: Rgba): Vec3 => [2 * r - 1, 2 * g - 1, 2 * b - 1];

/** The edges from the first corner of a triangle, and the changes of two coordinates along them. */
export interface EdgeSlopes {
  first: Vec3;
  second: Vec3;
  alongFirst: readonly [number, number];
  alongSecond: readonly [number, number];
}

/** The normal of a tangent-space normal map. */
export function bentAlongCoordinates(normal: Vec3, relief: Vec3, edges: EdgeSlopes): Vec3 {
  const [ofFirst, ofSecond] = [cross(edges.second, normal), cross(normal, edges.first)];
  const right = combined(edges.alongFirst[0], ofFirst, edges.alongSecond[0], ofSecond);
  const up = combined(edges.alongFirst[1], ofFirst, edges.alongSecond[1], ofSecond);
  const scale = 1 / Math.sqrt(Math.max(dot(right, right), dot(up, up)) || 1);
  return normalize(combined(1, combined(scale * relief[0], right, scale * relief[1], up), relief[2], normal));
}

/** The normal of an object-space normal map. side: 1 on front faces, −1 on back faces. */
export function bentInObject(relief: Vec3, toWorld: Mat3, side: number): Vec3 {
  const [x, y, z] = normalize(timesVector(toWorld, relief));
  return [side * x, side * y, side * z];
}

/**
 * The normal of a bump map (Mikkelsen, 2010). The steps lead one pixel to the right and up on the picture: heights are in pixels, whatever
 * the size of the surface.
 *
 * @param rises changes of height along both steps
 * @param side 1 on front faces, −1 on back faces
 */
export function bentByHeights(
  normal: Vec3,
  [right, up]: readonly [Vec3, Vec3],
  rises: readonly [number, number],
  side: number,
): Vec3 {
  const [x, y] = [normalize(right), normalize(up)];
  const [ofRight, ofUp] = [cross(y, normal), cross(normal, x)];
  const determinant = side * dot(x, ofRight);
  const gradient = combined(rises[0], ofRight, rises[1], ofUp);
  return normalize(combined(Math.abs(determinant), normal, -Math.sign(determinant), gradient));
}
