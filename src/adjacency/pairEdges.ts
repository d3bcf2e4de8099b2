import type { TriangleAdjacency } from './buildTriangleAdjacency.js';
import { isDegenerate } from './computeAreaNormals.js';
import { NO_TWIN, nextCorner } from './corners.js';
import { asPhase, inChunks } from './inChunks.js';
import { matchNonManifoldEdge } from './matchNonManifoldEdge.js';
import type { TriangleMesh } from './TriangleMesh.js';

/** No further half-edge on this edge. */
const END = 0xffffffff;

/**
 * Finds twins by counting sort: half-edges are sorted into one bucket per smaller end vertex, and within a bucket those
 * with the same larger end are chained. A marker array that remembers, per larger end, the latest half-edge seen takes
 * the place of a search, so a bucket of any size costs one visit per entry.
 */
export function* pairEdges(
  mesh: TriangleMesh,
  canonical: Uint32Array,
  areaNormals: Float64Array,
): Generator<number, Omit<TriangleAdjacency, 'areaNormals'>, void> {
  const { positions, indices } = mesh;
  const vertexCount = canonical.length;
  const triangleCount = indices.length / 3;

  // histogram over the smaller end
  const canonicalCorners = new Uint32Array(indices.length);
  /** First the sizes of the buckets, then, after the prefix sum, where each ends; while scattering, where it starts. */
  const bucketStarts = new Uint32Array(vertexCount + 1);
  let degenerateTriangles = 0;
  yield* asPhase(
    inChunks(triangleCount, (start, end) => {
      for (let triangle = start; triangle < end; triangle++) {
        const corner = 3 * triangle;
        const a = canonical[indices[corner]!]!;
        const b = canonical[indices[corner + 1]!]!;
        const c = canonical[indices[corner + 2]!]!;
        canonicalCorners[corner] = a;
        canonicalCorners[corner + 1] = b;
        canonicalCorners[corner + 2] = c;
        if (isDegenerate(areaNormals, triangle)) {
          degenerateTriangles++;
          continue;
        }
        bucketStarts[Math.min(a, b)]!++;
        bucketStarts[Math.min(b, c)]!++;
        bucketStarts[Math.min(c, a)]!++;
      }
    }),
    0,
    0.2,
  );

  // prefix sum
  let halfEdgeCount = 0;
  for (let vertex = 0; vertex <= vertexCount; vertex++) {
    halfEdgeCount += bucketStarts[vertex]!;
    bucketStarts[vertex] = halfEdgeCount;
  }

  // scatter, backwards, so that the order of triangles is kept inside a bucket and the ends become the starts
  const slotCorners = new Uint32Array(halfEdgeCount);
  const slotHighs = new Uint32Array(halfEdgeCount);
  yield* asPhase(
    inChunks(triangleCount, (start, end) => {
      for (let i = start; i < end; i++) {
        const triangle = triangleCount - 1 - i;
        if (isDegenerate(areaNormals, triangle)) continue;
        for (let corner = 3 * triangle + 2; corner >= 3 * triangle; corner--) {
          const from = canonicalCorners[corner]!;
          const to = canonicalCorners[nextCorner(corner)]!;
          const slot = --bucketStarts[Math.min(from, to)]!;
          slotCorners[slot] = corner;
          slotHighs[slot] = Math.max(from, to);
        }
      }
    }),
    0.2,
    0.5,
  );

  // chain the half-edges of each undirected edge: every slot points to the one before it on the same edge
  let steps = 0;
  const previousSlots = new Uint32Array(halfEdgeCount).fill(END);
  const isSuperseded = new Uint8Array(halfEdgeCount);
  /** Per larger end: the latest slot + 1. Slots of earlier buckets are recognised by their number, no reset needed. */
  const latest = new Uint32Array(vertexCount);
  let vertex = 0;
  yield* asPhase(
    inChunks(halfEdgeCount, (start, end) => {
      for (let slot = start; slot < end; slot++) {
        while (bucketStarts[vertex + 1]! <= slot) vertex++;
        const high = slotHighs[slot]!;
        const previous = latest[high]! - 1;
        if (previous >= bucketStarts[vertex]!) {
          previousSlots[slot] = previous;
          isSuperseded[previous] = 1;
        }
        latest[high] = slot + 1;
        steps++;
      }
    }),
    0.5,
    0.75,
  );

  // pair along each chain
  const twins = new Int32Array(indices.length).fill(NO_TWIN);
  let borderEdges = 0;
  let inconsistentEdges = 0;
  let nonManifoldEdges = 0;
  yield* asPhase(
    inChunks(halfEdgeCount, (start, end) => {
      for (let slot = start; slot < end; slot++) {
        if (isSuperseded[slot]) continue;
        const corner = slotCorners[slot]!;
        const second = previousSlots[slot]!;
        steps++;
        if (second === END) {
          borderEdges++;
          continue;
        }
        const third = previousSlots[second]!;
        if (third === END) {
          const twin = slotCorners[second]!;
          twins[corner] = twin;
          twins[twin] = corner;
          if (canonicalCorners[corner] === canonicalCorners[twin]) inconsistentEdges++;
          steps++;
          continue;
        }
        const group: number[] = [];
        for (let member = slot; member !== END; member = previousSlots[member]!) group.push(slotCorners[member]!);
        nonManifoldEdges++;
        steps += group.length + matchNonManifoldEdge(group, positions, canonicalCorners, twins);
      }
    }),
    0.75,
    1,
  );

  return { twins, canonicalCorners, borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles, steps };
}
