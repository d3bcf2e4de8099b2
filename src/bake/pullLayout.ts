/**
 * The `pull` vertex layout: every triangle has three vertices of its own, and what they need to know of the triangle is
 * pulled from textures. `TRIANGLE_WORDS` words per triangle (two texels of four) name the vertices of the triangle
 * adjacency primitive (paper, figure 5), and a float texture holds the positions of the vertices, one texel each.
 *
 *     V0, V1, V2, flags      flags: bit k is set at the first corner of all that uses vertex k of the triangle
 *     Vα, Vβ, Vγ, 0          the vertices opposite to edges 0, 1, 2; the own opposite one where there is no neighbour
 *
 * The vertices are those of the source, so each has one skin, one set of morph targets and one normal: a pass over them
 * deforms them all. The flags let that pass draw the corners and write each vertex once.
 */
export const TRIANGLE_WORDS = 8;

/** Words of the position texture per vertex: x, y, z and one that is not used. */
export const VERTEX_WORDS = 4;

/** WebGL2 promises textures of this width. It is even, so that both texels of a triangle lie in one row. */
const MOST_COLUMNS = 2048;

/** Columns and rows of a texture that holds so many texels, row by row. */
export function pullTextureSize(texels: number): { width: number; height: number } {
  const width = Math.min(texels, MOST_COLUMNS);
  return { width, height: Math.ceil(texels / width) };
}
