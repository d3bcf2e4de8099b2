import { computeAreaNormals } from './computeAreaNormals.js';
import { asPhase } from './inChunks.js';
import { pairEdges } from './pairEdges.js';
import type { TriangleMesh } from './TriangleMesh.js';
import { weldPositions } from './weldPositions.js';

/** How the edges of a mesh were paired. Counts of edges are counts of undirected edges after welding. */
export interface EdgeCounts {
  /** Edges with one triangle. */
  borderEdges: number;
  /** Edges with more than two triangles. */
  nonManifoldEdges: number;
  /** Edges with two triangles that run along it in the same direction: their windings contradict each other. */
  inconsistentEdges: number;
  /** Triangles without area. They have no neighbours and are nobody's neighbour. */
  degenerateTriangles: number;
}

/** Which triangle lies across which edge. */
export interface TriangleAdjacency extends EdgeCounts {
  /** For each corner the corner that starts the same edge in the neighbouring triangle, or NO_TWIN. Symmetric. */
  twins: Int32Array<ArrayBuffer>;
  /** For each corner its canonical vertex: corners at one position have the same. */
  canonicalCorners: Uint32Array<ArrayBuffer>;
  /** Three doubles per triangle: the normal, twice the area long; zero where degenerate. */
  areaNormals: Float64Array<ArrayBuffer>;
  /** Visits of hash slots and half-edges: a machine-independent measure of the time taken, at most linear in T. */
  steps: number;
}

/**
 * Welds the mesh by exact position and finds the twin of every edge, in O(V + T) however many triangles meet in a vertex.
 *
 * An edge of two triangles makes twins of its half-edges, also when the windings contradict each other (the shader
 * rebuilds the neighbour from the shared edge, which mends the winding). An edge of more triangles is matched by
 * `matchNonManifoldEdge`. The result does not depend on the order of triangles or vertices.
 *
 * `mesh` must be valid (see `TriangleMesh`).
 */
export function* buildTriangleAdjacency(mesh: TriangleMesh): Generator<number, TriangleAdjacency, void> {
  const { canonical, steps: weldSteps } = yield* asPhase(weldPositions(mesh.positions), 0, 0.25);
  const areaNormals = yield* asPhase(computeAreaNormals(mesh), 0.25, 0.4);
  const pairing = yield* asPhase(pairEdges(mesh, canonical, areaNormals), 0.4, 1);
  return { ...pairing, areaNormals, steps: weldSteps + pairing.steps };
}
