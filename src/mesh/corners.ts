/**
 * The corner conventions of the whole project.
 *
 * corner = 3·triangle + k, k ∈ {0, 1, 2}. Edge k runs from corner k to corner (k+1) mod 3. It has the number of the corner
 * it starts from, so one integer names both. The neighbour α lies across edge 0, β across edge 1, γ across edge 2 (Suarez
 * et al., figure 5). The twin of an edge is the same edge in the neighbouring triangle.
 *
 *        V2
 *       /  \          edge 0: V0 → V1, neighbour α
 *    γ /    \ β       edge 1: V1 → V2, neighbour β
 *     /      \        edge 2: V2 → V0, neighbour γ
 *   V0 ────── V1
 *         α
 */

/** The twin of an edge without one, at a border. */
export const NO_TWIN = -1;

/** The triangle that owns `corner`. */
export const triangleOf = (corner: number): number => (corner / 3) | 0;

/** The corner after `corner` in its own triangle, which is also the end of the edge that starts at `corner`. */
export const nextCorner = (corner: number): number => (corner % 3 === 2 ? corner - 2 : corner + 1);

/** The corner before `corner` in its own triangle: the one opposite to the edge that starts at `corner`. */
export const previousCorner = (corner: number): number => (corner % 3 === 0 ? corner + 2 : corner - 1);

/**
 * The opposite vertex of the neighbour across the edge that starts at `corner`. Without a neighbour it is the opposite vertex
 * of the corner's own triangle.
 */
export function vertexAcross(indices: Uint32Array, twins: Int32Array, corner: number): number {
  const twin = twins[corner];
  return indices[previousCorner(twin === NO_TWIN ? corner : twin)];
}
