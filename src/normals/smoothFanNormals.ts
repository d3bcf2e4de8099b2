import { NO_TWIN, nextCorner, previousCorner } from '../mesh/corners.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { Fans } from './buildFans.js';
import { heatSeries, longestHeatTime } from './heatSeries.js';

/**
 * Largest cotangent that is used as a weight, that of 5.7°: slivers have larger ones, and would take all the steps. All
 * three of a triangle are scaled down together; heat flows through slivers more slowly then, and still out of no place.
 */
const LARGEST_COTANGENT = 10;

/** A fan mixes at most this many times faster than the average one: those of the finest triangles take smaller steps. */
const LARGEST_RATE = 2;

/** What may be left of the finest noise. */
const TOLERANCE = 0.02;

/** More would take seconds on a million triangles. Enough for a radius of 40 mean edges, three times what scans need. */
const MOST_PASSES = 200;

/** A mesh of fans to smooth over. */
export interface FanSurface {
  mesh: TriangleMesh;
  /** Twins with NO_TWIN wherever two fans meet, except where windings contradict each other. */
  twins: Int32Array;
  canonicalCorners: Uint32Array;
  areaNormals: Float64Array;
  fans: Fans;
}

/** The heat equation over fans, in linear finite elements. */
interface Heat {
  /** The edges of fan i lie in entries starts[i] … starts[i + 1] − 1. */
  starts: Uint32Array;
  /** The fan at the other end of each edge. */
  neighbours: Uint32Array;
  /** Half the sum of the cotangents of the angles opposite to each edge. */
  weights: Float32Array;
  /** For each fan a third of the area around it. */
  masses: Float64Array;
  /** For each fan the sum of the magnitudes of its weights, which bounds the rate at which heat leaves it. */
  degrees: Float64Array;
}

/**
 * A vector per fan, near the direction of the surface at the scale of `radius`: heat flow over the surface from the mean
 * area normal of each fan, for the time radius²/4, in which heat spreads over about `radius`. Noise finer than that is
 * averaged away; nothing flows across edges that separate fans. What comes out depends on the shape, not on the triangles
 * it is made of: cotangent weights, and a time in object units instead of a number of passes. Vectors are zero where normals cancel and in fans of degenerate triangles.
 */
export function* smoothFanNormals(
  surface: FanSurface,
  radius: number,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const { fans, areaNormals } = surface;
  const sums = new Float64Array(3 * fans.count);
  const masses = new Float64Array(fans.count);
  yield* asPhase(
    forEachChunk(areaNormals.length / 3, (start, end) =>
      sumRange(areaNormals, fans.ofCorner, sums, masses, start, end),
    ),
    0,
    0.05,
  );
  const normals = new Float32Array(3 * fans.count);
  yield* asPhase(
    forEachChunk(fans.count, (start, end) => meanRange(sums, masses, normals, start, end)),
    0.05,
    0.1,
  );
  if (radius === 0) return normals;
  const heat = yield* asPhase(assemble(surface, masses), 0.1, 0.25);
  const time = radius ** 2 / 4;
  const rate = Math.min(highestRate(heat), longestHeatTime(MOST_PASSES, TOLERANCE) / time);
  return time * rate > 1e-6 ? yield* asPhase(flow(heat, normals, time * rate, rate), 0.25, 1) : normals;
}

/** Adds up the normals and masses of some triangles. */
function sumRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  sums: Float64Array,
  masses: Float64Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    // A third of the area; area normals are twice the area long.
    const x = areaNormals[first] / 6;
    const y = areaNormals[first + 1] / 6;
    const z = areaNormals[first + 2] / 6;
    const mass = Math.sqrt(x * x + y * y + z * z);
    for (let corner = first; corner < first + 3; corner++) {
      const fan = ofCorner[corner];
      masses[fan] += mass;
      sums[3 * fan] += x;
      sums[3 * fan + 1] += y;
      sums[3 * fan + 2] += z;
    }
  }
}

function meanRange(sums: Float64Array, masses: Float64Array, means: Float32Array, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    const mass = masses[fan] || 1;
    means[3 * fan] = sums[3 * fan] / mass;
    means[3 * fan + 1] = sums[3 * fan + 1] / mass;
    means[3 * fan + 2] = sums[3 * fan + 2] / mass;
  }
}

/** Sorts the edges by the fan they start from (counting sort). Every edge is there twice, once for either end. */
function* assemble(surface: FanSurface, masses: Float64Array): Generator<number, Heat, void> {
  const { areaNormals, fans } = surface;
  const cornerCount = fans.ofCorner.length;
  const cotangents = new Float32Array(cornerCount);
  yield* asPhase(
    forEachChunk(cornerCount / 3, (start, end) => cotangentRange(surface, cotangents, start, end)),
    0,
    0.3,
  );
  const starts = new Uint32Array(fans.count + 1);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => countRange(surface, starts, start, end)),
    0.3,
    0.5,
  );
  let edgeCount = 0;
  for (let fan = 0; fan <= fans.count; fan++) {
    edgeCount += starts[fan];
    starts[fan] = edgeCount;
  }
  const heat: Heat = {
    starts,
    neighbours: new Uint32Array(edgeCount),
    weights: new Float32Array(edgeCount),
    masses,
    degrees: new Float64Array(fans.count),
  };
  yield* asPhase(
    forEachChunk(areaNormals.length, (start, end) => scatterRange(surface, cotangents, heat, start, end)),
    0.5,
    1,
  );
  return heat;
}

/** The cotangents of the angles of some triangles, bounded; 0 in degenerate ones. */
function cotangentRange(
  { mesh: { positions, indices }, areaNormals }: FanSurface,
  cotangents: Float32Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const x = areaNormals[first];
    const y = areaNormals[first + 1];
    const z = areaNormals[first + 2];
    const area = Math.sqrt(x * x + y * y + z * z);
    if (area === 0) continue;
    const a = 3 * indices[first];
    const b = 3 * indices[first + 1];
    const c = 3 * indices[first + 2];
    const atA = dotFrom(positions, a, b, c) / area;
    const atB = dotFrom(positions, b, c, a) / area;
    const atC = dotFrom(positions, c, a, b) / area;
    const scale = LARGEST_COTANGENT / Math.max(LARGEST_COTANGENT, Math.abs(atA), Math.abs(atB), Math.abs(atC));
    cotangents[first] = scale * atA;
    cotangents[first + 1] = scale * atB;
    cotangents[first + 2] = scale * atC;
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

/** The twin that has the same fans at both ends, or NO_TWIN. */
function twinInFans({ twins, canonicalCorners }: FanSurface, corner: number): number {
  const twin = twins[corner];
  return twin === NO_TWIN || canonicalCorners[corner] === canonicalCorners[twin] ? NO_TWIN : twin;
}

/** A half-edge is the edge of the fan it starts from. Where it has no twin, also that of the fan it ends in. */
function countRange(surface: FanSurface, sizes: Uint32Array, start: number, end: number): void {
  const { ofCorner } = surface.fans;
  for (let corner = start; corner < end; corner++) {
    sizes[ofCorner[corner]]!++;
    if (twinInFans(surface, corner) === NO_TWIN) sizes[ofCorner[nextCorner(corner)]]!++;
  }
}

/** Enters edges from the back of each fan's range, so that in the end the range ends have become the starts. */
function scatterRange(
  surface: FanSurface,
  cotangents: Float32Array,
  { starts, neighbours, weights, degrees }: Heat,
  start: number,
  end: number,
): void {
  const { ofCorner } = surface.fans;
  for (let corner = start; corner < end; corner++) {
    const from = ofCorner[corner];
    const to = ofCorner[nextCorner(corner)];
    const twin = twinInFans(surface, corner);
    const across = twin === NO_TWIN ? 0 : cotangents[previousCorner(twin)];
    const weight = 0.5 * (cotangents[previousCorner(corner)] + across);
    let slot = --starts[from];
    neighbours[slot] = to;
    weights[slot] = weight;
    degrees[from] += Math.abs(weight);
    if (twin !== NO_TWIN) continue;
    slot = --starts[to];
    neighbours[slot] = from;
    weights[slot] = weight;
    degrees[to] += Math.abs(weight);
  }
}

/** The highest rate at which a fan mixes with its neighbours, bounded by LARGEST_RATE. */
function highestRate({ masses, degrees }: Heat): number {
  let highest = 0;
  let massSum = 0;
  let degreeSum = 0;
  for (let fan = 0; fan < masses.length; fan++) {
    if (masses[fan] === 0) continue;
    highest = Math.max(highest, degrees[fan] / masses[fan]);
    massSum += masses[fan];
    degreeSum += degrees[fan];
  }
  return massSum === 0 ? 0 : Math.min(highest, (LARGEST_RATE * degreeSum) / massSum);
}

/** e^(−steps·(1 − P))·normals, P = 1 − L/rate with L the Laplacian, by the recurrence of the Chebyshev polynomials. Uses up `normals`. */
function* flow(
  heat: Heat,
  normals: Float32Array<ArrayBuffer>,
  steps: number,
  rate: number,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const coefficients = heatSeries(steps, TOLERANCE);
  const result = normals.map((value) => coefficients[0] * value);
  let current = normals;
  let previous = new Float32Array(normals.length);
  const share = 1 / Math.max(1, coefficients.length - 1);
  for (let k = 1; k < coefficients.length; k++) {
    const scale = k === 1 ? 1 : 2;
    yield* asPhase(
      forEachChunk(heat.masses.length, (start, end) =>
        stepRange(heat, rate, scale, coefficients[k], current, previous, result, start, end),
      ),
      (k - 1) * share,
      k * share,
    );
    [current, previous] = [previous, current];
  }
  return result;
}

/**
 * Turns `previous`, Tₖ₋₁, into Tₖ₊₁ = scale·P·Tₖ − Tₖ₋₁ (scale 2; the first time 1, and T₋₁ = 0) and adds its part of the
 * series to `result`. A fan with so little area that it would mix faster than `rate` is given more, which
 * keeps the eigenvalues of P within [−1, 1]. Differences, not values, are summed, so that what is equal stays equal to the last bit.
 */
function stepRange(
  { starts, neighbours, weights, masses, degrees }: Heat,
  rate: number,
  scale: number,
  coefficient: number,
  current: Float32Array,
  previous: Float32Array,
  result: Float32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const x = current[3 * fan];
    const y = current[3 * fan + 1];
    const z = current[3 * fan + 2];
    let dx = 0;
    let dy = 0;
    let dz = 0;
    const last = starts[fan + 1];
    for (let edge = starts[fan]; edge < last; edge++) {
      const neighbour = 3 * neighbours[edge];
      const weight = weights[edge];
      dx += weight * (current[neighbour] - x);
      dy += weight * (current[neighbour + 1] - y);
      dz += weight * (current[neighbour + 2] - z);
    }
    const step = 1 / (Math.max(rate * masses[fan], degrees[fan]) || 1);
    const nextX = scale * (x + step * dx) - previous[3 * fan];
    const nextY = scale * (y + step * dy) - previous[3 * fan + 1];
    const nextZ = scale * (z + step * dz) - previous[3 * fan + 2];
    previous[3 * fan] = nextX;
    previous[3 * fan + 1] = nextY;
    previous[3 * fan + 2] = nextZ;
    result[3 * fan] += coefficient * nextX;
    result[3 * fan + 1] += coefficient * nextY;
    result[3 * fan + 2] += coefficient * nextZ;
  }
}
