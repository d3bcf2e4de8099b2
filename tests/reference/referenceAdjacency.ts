/** A point or vector in double precision. */
export type Vec3 = [number, number, number];
export type Triangle = [Vec3, Vec3, Vec3];

const key = (v: Vec3) => v.map((x) => (x === 0 ? 0 : x)).join(',');

/**
 * The neighbour across each edge of each triangle, by brute force over strings, for meshes in which at most two triangles share an edge.
 * Neighbours are oriented like the triangle itself.
 *
 * @returns per triangle, the triangles α, β, γ across the edges V0V1, V1V2, V2V0, or null at a border.
 */
export function referenceAdjacency(triangles: readonly Triangle[]): (Triangle | null)[][] {
  const byEdge = new Map<string, { triangle: number; opposite: Vec3 }[]>();
  const edgeKey = (a: Vec3, b: Vec3) => [key(a), key(b)].sort().join('|');
  triangles.forEach((t, triangle) => {
    for (let k = 0; k < 3; k++) {
      const edge = edgeKey(t[k], t[(k + 1) % 3]);
      byEdge.set(edge, [...(byEdge.get(edge) ?? []), { triangle, opposite: t[(k + 2) % 3] }]);
    }
  });
  return triangles.map((t, triangle) =>
    [0, 1, 2].map((k) => {
      const start = t[k];
      const end = t[(k + 1) % 3];
      const other = byEdge.get(edgeKey(start, end))!.find((side) => side.triangle !== triangle);
      return other === undefined ? null : ([end, start, other.opposite] as Triangle);
    }),
  );
}
