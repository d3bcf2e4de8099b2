import { readOctahedral } from './octahedral.js';

/**
 * The layout of the two textures that contours and feature edges are drawn from. Both hold unsigned integers (RGBA, 32 bits
 * each).
 *
 * `outlinePoints` has two texels per point. A point is a fan of corners that share one normal:
 *
 *     x, y, z as floats, normal     octahedral, two normalised 16-bit integers
 *     xx xy, xz yy, yz zz, vertex   K·R as half floats, two to a word; R is the radius of the bounding sphere
 *
 * K is the curvature tensor of `fanCurvatures`. `vertex` is a vertex of the geometry: the pre-pass that deforms the geometry
 * writes the deformed position of the point there.
 *
 * `outlinePrimitives` has one texel per triangle, then one per feature edge:
 *
 *     points 0, 1, 2, nothing                                    a triangle
 *     left start, left end, right start, right end               an edge, and its flags
 *
 * The lower four flags (`edgeFlags.ts`) lie in the highest four bits of the first word, the others in those of the second.
 */

/** Words of `outlinePoints` per point. */
export const POINT_WORDS = 8;

/** Words of `outlinePrimitives` per primitive. */
export const PRIMITIVE_WORDS = 4;

/** Bits of a word that hold the number of a point; the others hold flags. */
export const POINT_BITS = 28;

/** Mask of the number of a point in a word. */
export const POINT_MASK: number = 2 ** POINT_BITS - 1;

/** From this many triangles on, a search for contours takes more than about a millisecond, and runs in the worker on arrays of its own. */
export const SEARCHED_IN_WORKER = 100_000;

/** Unpacks the positions and unit normals of the first `count` points written by `packOutlines`. */
export function unpackPoints(
  words: Uint32Array<ArrayBuffer>,
  count: number,
): { positions: Float32Array<ArrayBuffer>; normals: Float32Array<ArrayBuffer> } {
  const floats = new Float32Array(words.buffer);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  for (let point = 0; point < count; point++) {
    const source = POINT_WORDS * point;
    positions[3 * point] = floats[source];
    positions[3 * point + 1] = floats[source + 1];
    positions[3 * point + 2] = floats[source + 2];
    readOctahedral(words[source + 3], normals, 3 * point);
  }
  return { positions, normals };
}
