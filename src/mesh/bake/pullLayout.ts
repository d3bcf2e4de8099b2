/**
 * The `pull` vertex layout: every triangle has three vertices of its own, which read ("pull") the rest from two textures. One
 * texture holds `TRIANGLE_WORDS` words (two texels) per triangle: the indices of the six adjacency vertices (Suarez et al.,
 * figure 5). The other, a float texture, holds the position of each vertex in one texel.
 *
 *     V0, V1, V2, flags      bit k of the flags is set if corner k is the first corner in the mesh that uses its vertex
 *     Vα, Vβ, Vγ, 0          the vertices opposite to edges 0, 1, 2; the triangle's own opposite vertex without a neighbour
 *
 * The vertices are those of the source geometry, so each has one skin, one set of morph targets and one normal, and a single
 * pre-pass deforms them all. The pre-pass draws the corners; the flags tell it to write each vertex only once.
 */
export const TRIANGLE_WORDS = 8;

/** Words of the position texture per vertex: x, y, z and padding. */
export const VERTEX_WORDS = 4;

/** The width of texture that WebGL2 guarantees. */
const MIN_COLUMNS = 2048;

/**
 * The width of a texture with `texels` texels, if it has more than one row. The width is a power of two, so that shaders need
 * not divide, and at least the height, so that every device that allows the width allows the height too. Both texels of a
 * triangle lie in the same row.
 */
export function pullColumns(texels: number): number {
  let columns = MIN_COLUMNS;
  while (columns * columns < texels) columns *= 2;
  return columns;
}

/** Width and height of a texture that holds `texels` texels, row by row. */
export function pullTextureSize(texels: number, columns = pullColumns(texels)): { width: number; height: number } {
  const width = Math.min(texels, columns);
  return { width, height: Math.ceil(texels / width) };
}

/** The number of words in a texture that holds `entries` entries, padding included. A texel has four words. */
export function paddedWords(entries: number, wordsPerEntry: number, columns?: number): number {
  const { width, height } = pullTextureSize((entries * wordsPerEntry) / 4, columns);
  return 4 * width * height;
}
