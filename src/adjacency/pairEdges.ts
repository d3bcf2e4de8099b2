import { isDegenerate } from '../mesh/computeAreaNormals.js';
import { NO_TWIN, nextCorner } from '../mesh/corners.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { EdgeCounts } from './EdgeCounts.js';
import { matchNonManifoldEdge } from './matchNonManifoldEdge.js';

/** What `pairEdges` returns. See `TriangleAdjacency`. */
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

/** Chains the half-edges of each undirected edge, from the last to the first. */
interface Chains {
  /** For each slot the previous slot on the same edge, or END. */
  previous: Uint32Array;
  /** 1 for each slot that a later slot links to, so that it is not the last of its chain. */
  hasSuccessor: Uint8Array;
}

const END = 0xffffffff;

/**
 * Finds twins by counting sort. Half-edges are sorted into one bucket per smaller end; within a bucket, those with the same
 * larger end are chained. An array holds the latest half-edge for each larger end, so nothing is searched: a bucket of any
 * size costs one visit per entry. Half-edges of degenerate triangles are left out.
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
  yield* asPhase(
    forEachChunk(triangleCount, (start, end) => {
      degenerateTriangles += countRange(canonicalCorners, areaNormals, starts, start, end);
    }),
    0,
    0.15,
  );
  let halfEdgeCount = 0;
  for (let vertex = 0; vertex <= vertexCount; vertex++) {
    halfEdgeCount += starts[vertex];
    starts[vertex] = halfEdgeCount;
  }

  const buckets = { starts, corners: new Uint32Array(halfEdgeCount), highs: new Uint32Array(halfEdgeCount) };
  yield* asPhase(
    forEachChunk(triangleCount, (start, end) =>
      scatterRange(canonicalCorners, areaNormals, buckets, triangleCount - end, triangleCount - start),
    ),
    0.15,
    0.45,
  );

  const chains = { previous: new Uint32Array(halfEdgeCount).fill(END), hasSuccessor: new Uint8Array(halfEdgeCount) };
  const latest = new Uint32Array(vertexCount);
  let low = 0;
  yield* asPhase(
    forEachChunk(halfEdgeCount, (start, end) => {
      low = chainRange(buckets, chains, latest, low, start, end);
    }),
    0.45,
    0.7,
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
  yield* asPhase(
    forEachChunk(halfEdgeCount, (start, end) =>
      pairRange(positions, canonicalCorners, buckets, chains, pairing, start, end),
    ),
    0.7,
    1,
  );
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

/**
 * Chains the slots of a range. `latest` holds the latest slot + 1 for each larger end. Entries of earlier buckets are
 * recognised by their lower numbers, so nothing needs to be reset. `low` is the bucket of the slot before the range; the
 * bucket of the last slot is returned.
 */
function chainRange(
  { starts, highs }: Buckets,
  { previous, hasSuccessor }: Chains,
  latest: Uint32Array,
  low: number,
  start: number,
  end: number,
): number {
  for (let slot = start; slot < end; slot++) {
    while (starts[low + 1] <= slot) low++;
    const high = highs[slot];
    const before = latest[high] - 1;
    if (before >= starts[low]) {
      previous[slot] = before;
      hasSuccessor[before] = 1;
    }
    latest[high] = slot + 1;
  }
  return low;
}

/** Pairs the chains that end in the slots of a range, and counts the edges. */
function pairRange(
  positions: Float32Array,
  canonicalCorners: Uint32Array,
  { corners }: Buckets,
  { previous, hasSuccessor }: Chains,
  pairing: Pairing,
  start: number,
  end: number,
): void {
  const { twins } = pairing;
  let inconsistentEdges = 0;
  let steps = end - start;
  for (let slot = start; slot < end; slot++) {
    if (hasSuccessor[slot] === 1) continue;
    const second = previous[slot];
    if (second === END) {
      pairing.borders.push(corners[slot]);
    } else if (previous[second] === END) {
      const corner = corners[slot];
      const twin = corners[second];
      twins[corner] = twin;
      twins[twin] = corner;
      if (canonicalCorners[corner] === canonicalCorners[twin]) inconsistentEdges++;
    } else {
      const group: number[] = [];
      for (let member = slot; member !== END; member = previous[member]) group.push(corners[member]);
      steps += group.length;
      matchNonManifoldEdge(group, positions, canonicalCorners, pairing);
    }
  }
  pairing.inconsistentEdges += inconsistentEdges;
  pairing.steps += steps;
}
