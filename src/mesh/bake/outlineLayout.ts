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
 * The lower four flags (below) lie in the highest four bits of the first word, the others in those of the second. Those of the third and
 * of the fourth word hold how close lines lie there: the radius is 2 to the power of that number / `SPACING_STEPS` times their distance.
 */

/** Words of `outlinePoints` per point. */
export const POINT_WORDS = 8;

/** Words of `outlinePrimitives` per primitive. */
export const PRIMITIVE_WORDS = 4;

/** Bits of a word that hold the number of a point; the others hold flags. */
export const POINT_BITS = 28;

/** Mask of the number of a point in a word. */
export const POINT_MASK: number = 2 ** POINT_BITS - 1;

/** Steps per halving of the distance of lines. */
export const SPACING_STEPS = 16;

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

// Bit flags of feature edges. An edge may have several; without a kind (`DRAWN_WHOLE`) it is drawn only where the contour runs along it.

/** The edge belongs to one triangle only. */
export const BORDER = 1;
/** The edge is sharp, and part of a chain of creases that is long enough. */
export const CREASE = 2;
/** The edge lies between two groups of triangles. */
export const MATERIAL_BORDER = 4;
/** The windings of the two triangles contradict each other. */
export const CONTRARY = 8;
/** At the start of the edge a straight line ends, branches or turns. */
export const CORNER_AT_START = 16;
/** At the end of the edge a straight line ends, branches or turns. */
export const CORNER_AT_END = 32;

/** The edge is a line along which two surfaces cut each other; its sides are those of one and of the other. */
export const INTERSECTION = 128;

/** The points of such an edge: its ends on one surface, and on the other. */
export const SEGMENT_POINTS = 4;

/** The kinds of edges of a surface that are drawn over their whole length. */
export const DRAWN_WHOLE: number = BORDER | CREASE | MATERIAL_BORDER;

/** Set for every feature edge, to distinguish it from a triangle. */
export const IS_EDGE = 64;

/** The flags that lie in the first word of an edge; the others lie in the second. */
export const LOW_FLAGS = 15;

const ONE = 0x7fff;

/**
 * Packs a unit vector into one word, as two normalised 16-bit integers. The vector is projected onto an octahedron whose lower
 * half is folded outwards (Cigolle et al., "A survey of efficient representations for independent unit vectors", 2014). The
 * error is at most 0.004°.
 */
export function octahedral(x: number, y: number, z: number): number {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  let u = x / sum;
  let v = y / sum;
  if (z < 0) {
    const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
    u = folded;
  }
  return (Math.round(u * ONE) & 0xffff) | ((Math.round(v * ONE) & 0xffff) << 16);
}

/** Unpacks the unit vector in `word` into `target`, at `offset`. */
function readOctahedral(word: number, target: Float32Array, offset: number): void {
  let x = Math.max(((word << 16) >> 16) / ONE, -1);
  let y = Math.max((word >> 16) / ONE, -1);
  const z = 1 - Math.abs(x) - Math.abs(y);
  const below = Math.max(-z, 0);
  x += x >= 0 ? -below : below;
  y += y >= 0 ? -below : below;
  const length = Math.sqrt(x * x + y * y + z * z);
  target[offset] = x / length;
  target[offset + 1] = y / length;
  target[offset + 2] = z / length;
}
