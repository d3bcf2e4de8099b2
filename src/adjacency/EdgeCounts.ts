/** How the edges of a mesh were paired. Edges are undirected and counted after welding. */
export interface EdgeCounts {
  /** Edges with one triangle. */
  borderEdges: number;
  /** Edges with more than two triangles. */
  nonManifoldEdges: number;
  /** Edges with two triangles that run along it in the same direction: their windings contradict each other. */
  inconsistentEdges: number;
  /** Triangles without area. They have no neighbours, are nobody's neighbour, and their edges are not counted. */
  degenerateTriangles: number;
}
