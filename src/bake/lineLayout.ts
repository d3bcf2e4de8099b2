/**
 * What contours and feature edges are drawn from, in two textures of unsigned integers (RGBA, 32 bits each).
 *
 * `linePoints` has two texels per point, which is a fan of corners with one normal:
 *
 *     x, y, z as floats, normal     octahedral, two normalised 16-bit integers
 *     xx xy, xz yy, yz zz, vertex   K·R as half floats, two to a word; R is the radius of the bounding sphere
 *
 * K is the curvature tensor of `fanCurvatures`, and vertex that of the geometry, for its place in the pre-pass that deforms.
 *
 * `linePrimitives` has one texel per triangle, then one per feature edge:
 *
 *     points 0, 1, 2, nothing                                    a triangle
 *     left start, left end, right start, right end               an edge, and its flags
 *
 * The flags (`edgeFlags.ts`) lie in the highest four bits of the first word, and those above in the second's.
 */

/** Words of `linePoints` per point. */
export const POINT_WORDS = 8;

/** Words of `linePrimitives` per primitive. */
export const PRIMITIVE_WORDS = 4;

/** Points are numbered in so many bits; the others hold flags. */
export const POINT_BITS = 28;

/** The bits of a point's number. */
export const POINT_MASK: number = 2 ** POINT_BITS - 1;
