/**
 * The `pull` vertex layout: every triangle has three vertices of its own, which read ("pull") the rest from two textures. One
 * holds `TRIANGLE_WORDS` words per triangle (two texels of four): the indices of the vertices of the adjacency primitive
 * (Suarez et al., figure 5). The other, a float texture, holds the position of each vertex in one texel.
 *
 *     V0, V1, V2, flags      flags: bit k is set at the first corner of all that uses vertex k of the triangle
 *     Vα, Vβ, Vγ, 0          the vertices opposite to edges 0, 1, 2; the triangle's own opposite one without a neighbour
 *
 * The vertices are those of the source, so each has one skin, one set of morph targets and one normal, and one pass over them
 * deforms them all. That pass draws the corners; with the flags it writes each vertex once.
 */
export const TRIANGLE_WORDS = 8;

/** Words of the position texture per vertex: x, y, z and an unused one. */
export const VERTEX_WORDS = 4;

/** WebGL2 guarantees textures of this width. */
const LEAST_COLUMNS = 2048;

/**
 * How wide textures of so many texels are that take more than one row. A power of two, so that shaders need not divide,
 * and no less than there are rows, so that devices allow the height. Both texels of a triangle lie in one row.
 */
export function pullColumns(texels: number): number {
  let columns = LEAST_COLUMNS;
  while (columns * columns < texels) columns *= 2;
  return columns;
}

/** Width and height of a texture that holds `texels` texels, row by row. */
export function pullTextureSize(texels: number, columns = pullColumns(texels)): { width: number; height: number } {
  const width = Math.min(texels, columns);
  return { width, height: Math.ceil(texels / width) };
}
