/** How the edges of a mesh were paired. Edges are undirected and counted after welding. */
export interface EdgeCounts {
  /** Edges with one triangle. */
  borderEdges: number;
  /** Edges with more than two triangles. */
  nonManifoldEdges: number;
  /** Those of them where not all triangles go in pairs: a triangle ends there, as at a border. */
  unpairedEdges: number;
  /** Edges that both their triangles run along in the same direction: the windings contradict each other. */
  inconsistentEdges: number;
  /** Triangles without area. They have no neighbours, are no triangle's neighbour, and their edges are not counted. */
  degenerateTriangles: number;
}
