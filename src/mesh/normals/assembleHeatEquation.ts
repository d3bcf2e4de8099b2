import { doubleArea } from '../computeAreaNormals.js';
import { NO_TWIN } from '../corners.js';
import { chunkPhase, release } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import type { Fans, SortedFans } from './fans.js';

/**
 * The largest cotangent that is used as a weight, that of 5.7°. The larger ones of slivers would force very small steps. All
 * three cotangents of a triangle are scaled down together, so that heat flows more slowly through slivers, but is conserved.
 */
const LARGEST_COTANGENT = 10;

/** A mesh and its fans, over which normals are smoothed. */
export interface FanSurface {
  mesh: TriangleMesh;
  /** Twins with NO_TWIN wherever two fans meet. */
  twins: Int32Array<ArrayBuffer>;
  canonicalCorners: Uint32Array<ArrayBuffer>;
  areaNormals: Float64Array<ArrayBuffer>;
  fans: Fans;
}

/** The heat equation over fans, discretised by linear finite elements. */
export interface HeatEquation {
  /** The edges of fan i lie in entries starts[i] … starts[i + 1] − 1. */
  starts: Uint32Array;
  /** For each edge the number of the fan at its other end. */
  neighbours: Uint32Array;
  /** For each edge half the sum of the cotangents of the two angles opposite to it. */
  weights: Float32Array;
  /** For each fan a third of the area of its triangles. */
  masses: Float64Array<ArrayBuffer>;
  /** For each fan the sum of the magnitudes of its weights: a bound on the rate at which heat leaves it. */
  degrees: Float64Array<ArrayBuffer>;
}

/**
 * Assembles the heat equation of sorted fans. Their edges are sorted by the fan they start from (counting sort); every edge is entered
 * twice, once for each end.
 *
 * @param masses see `HeatEquation`
 * @param sorted its `sizes` become `starts` of the equation
 */
export function* assembleHeatEquation(
  surface: FanSurface,
  masses: Float64Array<ArrayBuffer>,
  { numbers, sizes }: SortedFans,
): Generator<number, HeatEquation, void> {
  const { ofCorner, count } = surface.fans;
  const triangleCount = ofCorner.length / 3;
  const cotangents = new Float32Array(ofCorner.length);
  yield* chunkPhase(triangleCount, 0, 0.4, (start, end) => cotangentRange(surface, cotangents, start, end));
  const starts = sizes;
  let edgeCount = 0;
  for (let fan = 0; fan <= count; fan++) {
    edgeCount += starts[fan];
    starts[fan] = edgeCount;
  }
  const heat: HeatEquation = {
    starts,
    neighbours: new Uint32Array(edgeCount),
    weights: new Float32Array(edgeCount),
    masses,
    degrees: new Float64Array(count),
  };
  yield* chunkPhase(triangleCount, 0.4, 1, (start, end) =>
    scatterRange(surface, numbers, cotangents, heat, start, end),
  );
  release(cotangents);
  return heat;
}

/** Writes the cotangents of a range of triangles, limited to LARGEST_COTANGENT, for each edge that of the angle opposite; 0 in degenerate triangles. */
function cotangentRange(
  { mesh: { positions, indices }, areaNormals }: FanSurface,
  cotangents: Float32Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const area = doubleArea(areaNormals, first / 3);
    if (area === 0) continue;
    const a = 3 * indices[first];
    const b = 3 * indices[first + 1];
    const c = 3 * indices[first + 2];
    const atA = dotFrom(positions, a, b, c) / area;
    const atB = dotFrom(positions, b, c, a) / area;
    const atC = dotFrom(positions, c, a, b) / area;
    const scale = LARGEST_COTANGENT / Math.max(LARGEST_COTANGENT, Math.abs(atA), Math.abs(atB), Math.abs(atC));
    cotangents[first] = scale * atC;
    cotangents[first + 1] = scale * atA;
    cotangents[first + 2] = scale * atB;
  }
}

/** The scalar product of the edges from `origin` to `a` and to `b`. */
function dotFrom(positions: Float32Array, origin: number, a: number, b: number): number {
  const x = positions[origin];
  const y = positions[origin + 1];
  const z = positions[origin + 2];
  return (
    (positions[a] - x) * (positions[b] - x) +
    (positions[a + 1] - y) * (positions[b + 1] - y) +
    (positions[a + 2] - z) * (positions[b + 2] - z)
  );
}

/** Enters the edges of a range of triangles. The range of each fan is filled from its back: `starts` holds the ends of the ranges before, and their starts afterwards. */
function scatterRange(
  { twins, fans: { ofCorner } }: FanSurface,
  numbers: Uint32Array,
  cotangents: Float32Array,
  { starts, neighbours, weights, degrees }: HeatEquation,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    let from = numbers[ofCorner[first + 2]];
    for (let corner = first, edge = first + 2; corner < first + 3; edge = corner++) {
      const to = numbers[ofCorner[corner]];
      const twin = twins[edge];
      const weight = 0.5 * (cotangents[edge] + (twin === NO_TWIN ? 0 : cotangents[twin]));
      let slot = --starts[from];
      neighbours[slot] = to;
      weights[slot] = weight;
      degrees[from] += Math.abs(weight);
      if (twin === NO_TWIN) {
        slot = --starts[to];
        neighbours[slot] = from;
        weights[slot] = weight;
        degrees[to] += Math.abs(weight);
      }
      from = to;
    }
  }
}

/** The heat equation on a surface, or on a coarser copy of it. */
export interface HeatLevel {
  heat: HeatEquation;
  /** Three coordinates per node. Undefined where heat spreads over few nodes, so that no coarser copy is needed. */
  places: Float32Array | undefined;
  /** For each node the factor on the radius over which heat spreads there, at most 1. Undefined stands for 1 everywhere. */
  shares: Float32Array | undefined;
}
