import { isDegenerate } from '../computeAreaNormals.js';
import { NO_TWIN, nextCorner } from '../corners.js';
import { chunkPhase, release } from '../phases.js';
import { matchNonManifoldEdge } from './matchNonManifoldEdge.js';

/** How the edges of a mesh were paired. Edges are undirected and counted after welding. */
export interface EdgeCounts {
  /** Edges with one triangle. */
  borderEdges: number;
  /** Edges with more than two triangles. */
  nonManifoldEdges: number;
  /** Non-manifold edges whose triangles do not all go in pairs: a triangle ends there, as at a border. */
  unpairedEdges: number;
  /** Edges along which both triangles run in the same direction: their windings contradict each other. */
  inconsistentEdges: number;
  /** Triangles without area. They have no twins, are no twins, and their edges are not counted. */
  degenerateTriangles: number;
}

/** The result of `pairEdges`. See `TriangleAdjacency`. */
export interface Pairing extends Omit<EdgeCounts, 'borderEdges'> {
  twins: Int32Array<ArrayBuffer>;
  /** The half-edges that belong to only one triangle, each named by the corner that it starts from. */
  borders: number[];
  /** Visits of half-edges: a machine-independent measure of the time taken. */
  steps: number;
}

/** Half-edges sorted by the smaller of their two canonical vertices. */
interface Buckets {
  /** The half-edges whose smaller end is v lie in slots starts[v] … starts[v + 1] − 1. */
  starts: Uint32Array;
  /** The half-edge in each slot, named by the corner it starts from. */
  corners: Uint32Array;
  /** The larger end of the half-edge in each slot. */
  highs: Uint32Array;
}

/**
 * Finds twins by counting sort. Half-edges are sorted into one bucket per smaller end; within a bucket, an array holds the latest
 * half-edge for each larger end, so nothing is searched: a bucket of any size costs two visits per entry. Half-edges of degenerate
 * triangles are left out.
 */
export function* pairEdges(
  positions: Float32Array,
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
): Generator<number, Pairing, void> {
  const vertexCount = positions.length / 3;
  const triangleCount = canonicalCorners.length / 3;

  // First a histogram over the smaller ends, then its prefix sums: every entry is the end of its bucket.
  const starts = new Uint32Array(vertexCount + 1);
  let degenerateTriangles = 0;
  yield* chunkPhase(triangleCount, 0, 0.15, (start, end) => {
    degenerateTriangles += countRange(canonicalCorners, areaNormals, starts, start, end);
  });
  let halfEdgeCount = 0;
  for (let vertex = 0; vertex <= vertexCount; vertex++) {
    halfEdgeCount += starts[vertex];
    starts[vertex] = halfEdgeCount;
  }

  const buckets = { starts, corners: new Uint32Array(halfEdgeCount), highs: new Uint32Array(halfEdgeCount) };
  yield* chunkPhase(triangleCount, 0.15, 0.45, (start, end) =>
    scatterRange(canonicalCorners, areaNormals, buckets, triangleCount - end, triangleCount - start),
  );

  const pairing: Pairing = {
    twins: new Int32Array(canonicalCorners.length).fill(NO_TWIN),
    borders: [],
    nonManifoldEdges: 0,
    unpairedEdges: 0,
    inconsistentEdges: 0,
    degenerateTriangles,
    steps: halfEdgeCount,
  };
  const pairs = { positions, canonicalCorners, latest: new Uint32Array(vertexCount), pairing };
  let low = 0;
  yield* chunkPhase(halfEdgeCount, 0.45, 1, (_, end) => {
    low = pairRange(pairs, buckets, low, end);
  });
  release(starts, buckets.corners, buckets.highs, pairs.latest);
  return pairing;
}

/**
 * Adds the half-edges of a range of triangles to `sizes`, the histogram over smaller ends. Returns the number of degenerate
 * triangles, which are left out.
 */
function countRange(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
  sizes: Uint32Array,
  start: number,
  end: number,
): number {
  let degenerateTriangles = 0;
  for (let triangle = start; triangle < end; triangle++) {
    if (isDegenerate(areaNormals, triangle)) {
      degenerateTriangles++;
      continue;
    }
    const a = canonicalCorners[3 * triangle];
    const b = canonicalCorners[3 * triangle + 1];
    const c = canonicalCorners[3 * triangle + 2];
    sizes[Math.min(a, b)]++;
    sizes[Math.min(b, c)]++;
    sizes[Math.min(c, a)]++;
  }
  return degenerateTriangles;
}

/**
 * Puts the half-edges of a range of triangles into their buckets. Each bucket is filled from its back: `starts` holds the
 * ends of the buckets before, and their starts afterwards. Triangles are taken backwards, so that a bucket keeps their order.
 */
function scatterRange(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
  { starts, corners, highs }: Buckets,
  start: number,
  end: number,
): void {
  for (let triangle = end - 1; triangle >= start; triangle--) {
    if (isDegenerate(areaNormals, triangle)) continue;
    for (let corner = 3 * triangle + 2; corner >= 3 * triangle; corner--) {
      const from = canonicalCorners[corner];
      const to = canonicalCorners[nextCorner(corner)];
      const slot = --starts[Math.min(from, to)];
      corners[slot] = corner;
      highs[slot] = Math.max(from, to);
    }
  }
}

/** The input and the scratch memory of the pairing. */
interface Pairs {
  positions: Float32Array;
  canonicalCorners: Uint32Array;
  /**
   * The slot + 1 of a half-edge for each larger end: the first in the bucket until there is a second. Entries of earlier buckets are
   * recognised by their lower numbers, so nothing needs to be reset.
   */
  latest: Uint32Array;
  pairing: Pairing;
}

/** Pairs the buckets from `low` on that begin before the slot `end`. Returns the bucket after these. */
function pairRange(pairs: Pairs, buckets: Buckets, low: number, end: number): number {
  const { starts } = buckets;
  let bucket = low;
  for (; starts[bucket] < end; bucket++) {
    if (starts[bucket] < starts[bucket + 1]) pairBucket(pairs, buckets, starts[bucket], starts[bucket + 1]);
  }
  return bucket;
}

/** Pairs the half-edges of a bucket, and counts the edges. */
function pairBucket(pairs: Pairs, { corners, highs }: Buckets, first: number, end: number): void {
  const { canonicalCorners, latest, pairing } = pairs;
  const { twins } = pairing;
  let crowded: Map<number, number[]> | null = null;
  for (let slot = first; slot < end; slot++) {
    const high = highs[slot];
    const before = latest[high] - 1;
    if (before < first) {
      latest[high] = slot + 1;
      continue;
    }
    const corner = corners[slot];
    const other = corners[before];
    const twin = twins[other];
    if (twin === NO_TWIN) {
      twins[corner] = other;
      twins[other] = corner;
      if (canonicalCorners[corner] === canonicalCorners[other]) pairing.inconsistentEdges++;
      continue;
    }
    // A non-manifold edge.
    crowded ??= new Map();
    const group = crowded.get(high);
    if (group) group.push(corner);
    else crowded.set(high, [other, twin, corner]);
  }
  for (let slot = first; slot < end; slot++) {
    if (twins[corners[slot]] === NO_TWIN && !crowded?.has(highs[slot])) pairing.borders.push(corners[slot]);
  }
  pairing.steps += end - first;
  if (crowded) for (const group of crowded.values()) pairCrowded(pairs, group);
}

/** Pairs the half-edges of an edge of more than two triangles, of which the first two were paired. */
function pairCrowded({ positions, canonicalCorners, pairing }: Pairs, group: readonly number[]): void {
  const [one, other] = group;
  pairing.twins[one] = NO_TWIN;
  pairing.twins[other] = NO_TWIN;
  if (canonicalCorners[one] === canonicalCorners[other]) pairing.inconsistentEdges--;
  pairing.steps += group.length;
  matchNonManifoldEdge(group, positions, canonicalCorners, pairing);
}
