import { computeAreaNormals } from '../computeAreaNormals.js';
import { NO_TWIN } from '../corners.js';
import { asPhase, chunkPhase, forEachChunk, release } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';
import { joinBorders, type Nearness } from './joinBorders.js';
import { type EdgeCounts, pairEdges } from './pairEdges.js';

/** For each edge, the triangle across it. */
export interface TriangleAdjacency extends EdgeCounts {
  /** For each corner the corner that starts the same edge in the neighbouring triangle, or NO_TWIN. Symmetric. */
  twins: Int32Array<ArrayBuffer>;
  /** For each corner its canonical vertex. Corners at the same position share one, and so do corners that were joined. Not to be changed. */
  canonicalCorners: Uint32Array<ArrayBuffer>;
  /** Three doubles per triangle, see `computeAreaNormals`. Zero where degenerate. */
  areaNormals: Float64Array<ArrayBuffer>;
  /** Visits of hash slots and half-edges: a machine-independent measure of the time taken. */
  steps: number;
}

/** Only vertices at exactly the same position are joined. */
const EXACT: Nearness = { tolerance: 0, rounding: 0 };

/**
 * Welds the mesh by exact position and finds the twin of every edge, in O(V + T) however many triangles meet in a vertex.
 *
 * The two half-edges of a manifold edge become twins even if the windings contradict each other: the shader rebuilds the
 * neighbour from the shared edge, which repairs the winding. A non-manifold edge of n triangles is matched by
 * `matchNonManifoldEdge` in O(n log n). Borders that lie near each other are joined afterwards (`joinBorders`). The result
 * does not depend on the order of triangles or vertices.
 *
 * `mesh` must be valid (see `TriangleMesh`).
 */
export function* buildTriangleAdjacency(
  mesh: TriangleMesh,
  nearness: Nearness = EXACT,
): Generator<number, TriangleAdjacency, void> {
  const { positions } = mesh;
  const { canonicalCorners, steps: weldSteps } = yield* asPhase(weldCorners(mesh), 0, 0.3);
  const areaNormals = yield* asPhase(computeAreaNormals(mesh), 0.3, 0.4);
  const pairing = yield* asPhase(pairEdges(positions, canonicalCorners, areaNormals), 0.4, 0.9);
  const paired = { positions, canonicalCorners, areaNormals, pairing };
  yield* asPhase(joinBorders(paired, nearness), 0.9, 1);
  yield 1;
  const { borders, steps, ...found } = pairing;
  return {
    ...found,
    borderEdges: borders.length,
    canonicalCorners: paired.canonicalCorners,
    areaNormals,
    steps: weldSteps + steps,
  };
}

/** The canonical vertex of each corner. If no two vertices share a position, as in most scans, it is the index of the mesh itself. */
function* weldCorners({
  positions,
  indices,
}: TriangleMesh): Generator<number, Pick<TriangleAdjacency, 'canonicalCorners' | 'steps'>, void> {
  const { canonical, steps } = yield* asPhase(weldPositions(positions), 0, 0.8);
  if (isIdentity(canonical)) {
    release(canonical);
    return { canonicalCorners: indices, steps };
  }
  const canonicalCorners = new Uint32Array(indices.length);
  yield* chunkPhase(indices.length, 0.8, 1, (start, end) =>
    gatherRange(canonical, indices, canonicalCorners, start, end),
  );
  release(canonical);
  return { canonicalCorners, steps };
}

function isIdentity(map: Uint32Array): boolean {
  for (let i = 0; i < map.length; i++) if (map[i] !== i) return false;
  return true;
}

function gatherRange(
  canonical: Uint32Array,
  indices: Uint32Array,
  canonicalCorners: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) canonicalCorners[corner] = canonical[indices[corner]];
}

/**
 * Returns the twins, with NO_TWIN also where the windings of the two triangles contradict each other.
 *
 * @param consistent the twins of the adjacency, which are changed; by default a copy
 */
export function* consistentTwins(
  {
    twins,
    canonicalCorners,
    inconsistentEdges,
  }: Pick<TriangleAdjacency, 'twins' | 'canonicalCorners' | 'inconsistentEdges'>,
  consistent: Int32Array<ArrayBuffer> = twins.slice(),
): Generator<number, Int32Array<ArrayBuffer>, void> {
  if (inconsistentEdges === 0) return consistent;
  yield* forEachChunk(twins.length, (start, end) => dropRange(canonicalCorners, consistent, start, end));
  return consistent;
}

/** Half-edges are judged one by one; both halves of an edge get the same result. */
function dropRange(canonicalCorners: Uint32Array, twins: Int32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin !== NO_TWIN && canonicalCorners[corner] === canonicalCorners[twin]) twins[corner] = NO_TWIN;
  }
}
