import { doubleArea, isDegenerate } from '../computeAreaNormals.js';
import { nextCorner } from '../corners.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';

/** No triangle, or no half-edge. */
const NONE = -1;

/** A triangle that is in no patch, because it has no area. */
export const NO_PATCH = 0xffffffff;

/** Connected parts of a mesh, in each of which all triangles can face the same side. */
export interface Patches {
  /** The patch of each triangle, or `NO_PATCH`. */
  patchOf: Uint32Array;
  /** For each triangle 1 if it must be turned so that its patch is consistent. The greater part of a patch, by area, stays as it is. */
  turned: Uint8Array<ArrayBuffer>;
  /** For each patch, whether every edge has exactly two triangles, and all windings agree after turning. */
  isClosed: boolean[];
  /** The area of each patch, twice. */
  doubleAreas: number[];
}

/**
 * Finds the patches of a mesh: triangles connected across edges of exactly two triangles, as in Takayama et al., "A Simple Method for
 * Correcting Facet Orientations in Polygon Meshes Based on Ray Casting", 2014. Takes linear time.
 *
 * @param canonicalCorners the welded vertex of each corner
 * @param areaNormals of the triangles, see `computeAreaNormals`
 */
export function* consistentPatches(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
): Generator<number, Patches, void> {
  const opposite = yield* asPhase(pairManifoldEdges(canonicalCorners, areaNormals), 0, 0.6);
  return yield* asPhase(flood(canonicalCorners, areaNormals, opposite), 0.6, 1);
}

/** For each corner the corner at which the other half-edge of its edge starts, or `NONE` unless the edge has exactly two triangles. */
function* pairManifoldEdges(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
): Generator<number, Int32Array, void> {
  const cornerCount = canonicalCorners.length;
  let vertexCount = 0;
  for (let corner = 0; corner < cornerCount; corner++)
    if (canonicalCorners[corner] >= vertexCount) vertexCount = canonicalCorners[corner] + 1;
  // A counting sort of the half-edges by the smaller of their ends.
  const starts = new Uint32Array(vertexCount + 1);
  const highEnds = new Uint32Array(cornerCount);
  countEdges(canonicalCorners, areaNormals, starts, highEnds);
  yield 0.3;
  const sorted = new Uint32Array(starts[vertexCount]);
  sortEdges(canonicalCorners, areaNormals, starts.slice(), sorted);
  yield 0.5;
  const opposite = new Int32Array(cornerCount).fill(NONE);
  /** The first half-edge to each vertex from the present smaller end, and how many there are. */
  const first = new Int32Array(vertexCount).fill(NONE);
  const found = new Uint32Array(vertexCount);
  const edges = { starts, sorted, highEnds, opposite, first, found };
  yield* chunkPhase(vertexCount, 0.5, 1, (start, end) => pairRange(edges, start, end));
  return opposite;
}

/** Counts the half-edges from each smaller end, as a sum up to the next one, and writes their greater ends. */
function countEdges(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
  starts: Uint32Array,
  highEnds: Uint32Array,
): void {
  for (let triangle = 0; triangle < canonicalCorners.length / 3; triangle++) {
    const isCounted = !isDegenerate(areaNormals, triangle);
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const from = canonicalCorners[corner];
      const to = canonicalCorners[nextCorner(corner)];
      highEnds[corner] = from < to ? to : from;
      if (isCounted) starts[(from < to ? from : to) + 1]++;
    }
  }
  for (let vertex = 1; vertex < starts.length; vertex++) starts[vertex] += starts[vertex - 1];
}

function sortEdges(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
  slots: Uint32Array,
  sorted: Uint32Array,
): void {
  for (let triangle = 0; triangle < canonicalCorners.length / 3; triangle++) {
    if (isDegenerate(areaNormals, triangle)) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const from = canonicalCorners[corner];
      const to = canonicalCorners[nextCorner(corner)];
      sorted[slots[from < to ? from : to]++] = corner;
    }
  }
}

/** Half-edges sorted by their smaller ends, and what is found of them. */
interface SortedEdges {
  starts: Uint32Array;
  sorted: Uint32Array;
  highEnds: Uint32Array;
  opposite: Int32Array;
  first: Int32Array;
  found: Uint32Array;
}

/** Pairs the half-edges from a range of smaller ends. */
function pairRange(
  { starts, sorted, highEnds, opposite, first, found }: SortedEdges,
  start: number,
  end: number,
): void {
  for (let low = start; low < end; low++) {
    const from = starts[low];
    const to = starts[low + 1];
    for (let slot = from; slot < to; slot++) {
      const corner = sorted[slot];
      const high = highEnds[corner];
      if (found[high]++ === 0) first[high] = corner;
      else {
        opposite[corner] = first[high];
        opposite[first[high]] = corner;
      }
    }
    for (let slot = from; slot < to; slot++) if (found[highEnds[sorted[slot]]] !== 2) opposite[sorted[slot]] = NONE;
    for (let slot = from; slot < to; slot++) found[highEnds[sorted[slot]]] = 0;
  }
}

function* flood(
  canonicalCorners: Uint32Array,
  areaNormals: Float64Array,
  opposite: Int32Array,
): Generator<number, Patches, void> {
  const triangleCount = canonicalCorners.length / 3;
  const patches: Patches = {
    patchOf: new Uint32Array(triangleCount).fill(NO_PATCH),
    turned: new Uint8Array(triangleCount),
    isClosed: [],
    doubleAreas: [],
  };
  const { patchOf, turned } = patches;
  const queue = new Uint32Array(triangleCount);
  yield* forEachChunk(triangleCount, (start, end) => {
    for (let seed = start; seed < end; seed++) {
      if (patchOf[seed] !== NO_PATCH || isDegenerate(areaNormals, seed)) continue;
      const patch = patches.isClosed.length;
      let isClosed = true;
      /** Half-edges whose windings contradict each other, in the file and after turning. Those of a Möbius strip cannot all be put right. */
      let contrary = 0;
      let left = 0;
      const areas = [0, 0];
      queue[0] = seed;
      patchOf[seed] = patch;
      let length = 1;
      for (let at = 0; at < length; at++) {
        const triangle = queue[at];
        areas[turned[triangle]] += doubleArea(areaNormals, triangle);
        for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
          const other = opposite[corner];
          if (other === NONE) {
            isClosed = false;
            continue;
          }
          const next = (other / 3) | 0;
          // Two half-edges that start at the same vertex run in the same direction: the windings contradict each other.
          const contradicts = canonicalCorners[other] === canonicalCorners[corner] ? 1 : 0;
          if (patchOf[next] === NO_PATCH) {
            patchOf[next] = patch;
            turned[next] = turned[triangle] ^ contradicts;
            queue[length++] = next;
          } else if (turned[next] !== (turned[triangle] ^ contradicts)) {
            isClosed = false;
            left++;
          }
          contrary += contradicts;
        }
      }
      if (left > 0 && contrary <= left) for (let at = 0; at < length; at++) turned[queue[at]] = 0;
      else if (areas[1] > areas[0]) for (let at = 0; at < length; at++) turned[queue[at]] ^= 1;
      patches.isClosed.push(isClosed);
      patches.doubleAreas.push(areas[0] + areas[1]);
    }
  });
  return patches;
}
