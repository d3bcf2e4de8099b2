import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from './assembleHeatEquation.js';
import { heatSeries, longestHeatTime } from './heatSeries.js';

/** No fan mixes faster than this many times the average rate: fans of very small triangles are slowed down. */
const LARGEST_RATE = 2;

/** Share of the finest noise that may remain. */
const TOLERANCE = 0.02;

/** Enough for a radius of 40 mean edges, three times what scans need. More would take seconds on a million triangles. */
const MOST_PASSES = 200;

/**
 * Smooths normals at the scale of `radius`, in object units. Starts from the mean normal of each fan and lets it diffuse
 * over the surface like heat, for the time radius²/4, in which heat spreads over about `radius`. Finer noise is averaged
 * away; nothing flows across edges that separate fans. The result depends on the shape and not on its triangulation, thanks
 * to cotangent weights and a time in object units instead of a number of passes.
 *
 * @returns x, y, z per fan, not of unit length; zero where normals cancel and in fans of degenerate triangles
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
  const heat = yield* asPhase(assembleHeatEquation(surface, masses), 0.1, 0.25);
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

/** The highest rate at which a fan mixes with its neighbours, limited by LARGEST_RATE. */
function highestRate({ masses, degrees }: HeatEquation): number {
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

/**
 * e^(−steps·(1 − P))·normals with P = 1 − L/rate, L the Laplacian, by the recurrence of the Chebyshev polynomials. Overwrites
 * `normals`.
 */
function* flow(
  heat: HeatEquation,
  normals: Float32Array<ArrayBuffer>,
  steps: number,
  rate: number,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const coefficients = heatSeries(steps, TOLERANCE);
  const result = scaled(normals, coefficients[0]);
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

/** A loop: `map` calls a function for each value, which measured ten times as slow. */
function scaled(values: Float32Array, factor: number): Float32Array<ArrayBuffer> {
  const result = new Float32Array(values.length);
  for (let i = 0; i < values.length; i++) result[i] = factor * values[i];
  return result;
}

/**
 * Turns `previous`, Tₖ₋₁, into Tₖ₊₁ = scale·P·Tₖ − Tₖ₋₁ (scale 2; in the first step 1, and T₋₁ = 0) and adds its term of the
 * series to `result`. A fan with so little area that it would mix faster than `rate` is treated as larger, which keeps the
 * eigenvalues of P within [−1, 1]. Differences are summed, not values, so equal neighbours stay equal to the last bit.
 */
function stepRange(
  { starts, neighbours, weights, masses, degrees }: HeatEquation,
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
