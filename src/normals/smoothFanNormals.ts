import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from './assembleHeatEquation.js';
import { heatSeries, longestHeatTime } from './heatSeries.js';

/** The largest rate of mixing, as a multiple of the mean rate. Fans of very small triangles are slowed down to it. */
const LARGEST_RATE = 2;

/** The share of the finest noise that may remain. */
const TOLERANCE = 0.02;

/**
 * The largest number of passes. It is enough for a radius of 40 mean edges, three times what scans need; more passes would take
 * seconds on a million triangles.
 */
const MAX_PASSES = 200;

/**
 * Smooths normals at the scale of each of `radii`, in object units. The mean normal of each fan diffuses over the surface like
 * heat, for the time radius²/4, in which heat spreads over about `radius`. Finer noise is averaged away; nothing flows across
 * edges that separate fans. The result depends on the shape and not on its triangulation, thanks to cotangent weights and a
 * time in object units instead of a number of passes.
 *
 * Several radii cost little more than the largest of them, because they are parts of one flow.
 *
 * @returns for each radius a vector per fan (x, y, z), not of unit length. It is zero where normals cancel and for fans that
 *   only have degenerate triangles.
 */
export function* smoothFanNormals(
  surface: FanSurface,
  radii: readonly number[],
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  if (radii.every((radius) => radius === 0)) {
    const { normals } = yield* meanNormals(surface);
    return radii.map(() => normals);
  }
  const flow = yield* asPhase(startFlow(surface), 0, 0.25);
  return yield* asPhase(diffuse(flow, radii), 0.25, 1);
}

/** The mean normal of each fan, three floats, and the equation by which they diffuse. */
export interface NormalFlow {
  normals: Float32Array<ArrayBuffer>;
  heat: HeatEquation;
}

/** Prepares `diffuse`. */
export function* startFlow(surface: FanSurface): Generator<number, NormalFlow, void> {
  const { normals, masses } = yield* asPhase(meanNormals(surface), 0, 0.4);
  return { normals, heat: yield* asPhase(assembleHeatEquation(surface, masses), 0.4, 1) };
}

/**
 * Smooths normals that were prepared for it, as `smoothFanNormals` does.
 *
 * @param shares for each fan the share of the radii that is used around it, at most 1. Default: 1 everywhere
 */
export function* diffuse(
  { normals, heat }: NormalFlow,
  radii: readonly number[],
  shares?: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const smoothed = radii.map(() => normals);
  const flows = planFlows(radii, highestRate(heat));
  for (const [i, { rate, parts }] of flows.entries()) {
    const series = parts.map(({ steps }) => heatSeries(steps, TOLERANCE));
    const task = flow(heat, normals.slice(), rate, shares, series);
    const results = yield* asPhase(task, i / flows.length, (i + 1) / flows.length);
    for (const [k, { radius }] of parts.entries()) smoothed[radius] = results[k];
  }
  return smoothed;
}

/** The mean normal of each fan, and a third of the area of its triangles. */
function* meanNormals({
  fans,
  areaNormals,
}: FanSurface): Generator<number, Pick<NormalFlow, 'normals'> & Pick<HeatEquation, 'masses'>, void> {
  const sums = new Float64Array(3 * fans.count);
  const masses = new Float64Array(fans.count);
  yield* asPhase(
    forEachChunk(areaNormals.length / 3, (start, end) =>
      sumRange(areaNormals, fans.ofCorner, sums, masses, start, end),
    ),
    0,
    0.5,
  );
  const normals = new Float32Array(3 * fans.count);
  yield* asPhase(
    forEachChunk(fans.count, (start, end) => meanRange(sums, masses, normals, start, end)),
    0.5,
    1,
  );
  return { normals, masses };
}

/** A flow whose parts take the same steps, though some take more of them than others. */
interface FlowPlan {
  /** The highest rate at which fans mix. */
  rate: number;
  /** The index of each radius in this flow, and its number of steps. */
  parts: { radius: number; steps: number }[];
}

/** Radii for which no fan must be slowed down become parts of one flow; each of the others gets a flow of its own. */
function planFlows(radii: readonly number[], highest: number): FlowPlan[] {
  const plans: FlowPlan[] = [];
  for (const [i, radius] of radii.entries()) {
    const time = radius ** 2 / 4;
    const rate = Math.min(highest, longestHeatTime(MAX_PASSES, TOLERANCE) / time);
    if (!(time * rate > 1e-6)) continue;
    const part = { radius: i, steps: time * rate };
    const plan = plans.find((other) => other.rate === rate);
    if (plan) plan.parts.push(part);
    else plans.push({ rate, parts: [part] });
  }
  return plans;
}

/** Adds the normals and masses of a range of triangles to those of their fans. */
function sumRange(
  areaNormals: Float64Array,
  ofCorner: Uint32Array,
  sums: Float64Array,
  masses: Float64Array,
  start: number,
  end: number,
): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    // This makes the length a third of the area, since area normals are twice the area long.
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
 * Computes Σ cₖ·Tₖ(P)·normals for each series of coefficients cₖ, where P = 1 − L/rate and L is the Laplacian, by the recurrence
 * of the Chebyshev polynomials. With the coefficients of `heatSeries` that is e^(−steps·(1 − P))·normals. Overwrites `normals`.
 */
function* flow(
  heat: HeatEquation,
  normals: Float32Array<ArrayBuffer>,
  rate: number,
  shares: Float32Array | undefined,
  series: readonly (readonly number[])[],
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const fanCount = heat.masses.length;
  const results = series.map(([first]) => scaled(normals, first));
  const steps = new Float64Array(fanCount);
  for (let fan = 0; fan < fanCount; fan++) steps[fan] = 1 / (Math.max(rate * heat.masses[fan], heat.degrees[fan]) || 1);
  // Heat spreads over a share of the radius in that share, squared, of the time.
  if (shares) for (let fan = 0; fan < fanCount; fan++) steps[fan] *= shares[fan] ** 2;
  let current = normals;
  let previous = new Float32Array(normals.length);
  const passes = Math.max(...series.map(({ length }) => length)) - 1;
  for (let k = 1; k <= passes; k++) {
    const scale = k === 1 ? 1 : 2;
    const terms = series.flatMap((coefficients, i) =>
      k < coefficients.length ? [{ coefficient: coefficients[k], result: results[i] }] : [],
    );
    yield* asPhase(
      forEachChunk(fanCount, (start, end) => stepRange(heat, steps, scale, terms, current, previous, start, end)),
      (k - 1) / passes,
      k / passes,
    );
    [current, previous] = [previous, current];
  }
  return results;
}

/** Multiplies values by a factor. `map` would call a function for each value, which was measured to be ten times as slow. */
function scaled(values: Float32Array, factor: number): Float32Array<ArrayBuffer> {
  const result = new Float32Array(values.length);
  for (let i = 0; i < values.length; i++) result[i] = factor * values[i];
  return result;
}

/** A term of a series, which is added to `result`. */
interface Term {
  coefficient: number;
  result: Float32Array;
}

/**
 * Turns `previous`, which holds Tₖ₋₁, into Tₖ₊₁ = scale·P·Tₖ − Tₖ₋₁ and adds its terms to the results of the series. `scale` is
 * 2, except in the first step: there it is 1, and T₋₁ = 0. A fan with so little area that it would mix faster than the rate is
 * treated as larger, which keeps the eigenvalues of P within [−1, 1]. The sum is one of differences, not of values, so equal
 * neighbours stay equal to the last bit.
 */
function stepRange(
  { starts, neighbours, weights }: HeatEquation,
  steps: Float64Array,
  scale: number,
  terms: readonly Term[],
  current: Float32Array,
  previous: Float32Array,
  start: number,
  end: number,
): void {
  let edge = starts[start];
  for (let fan = start; fan < end; fan++) {
    const i = 3 * fan;
    const x = current[i];
    const y = current[i + 1];
    const z = current[i + 2];
    let dx = 0;
    let dy = 0;
    let dz = 0;
    for (const last = starts[fan + 1]; edge < last; edge++) {
      const neighbour = neighbours[edge];
      const weight = weights[edge];
      dx += weight * (current[neighbour] - x);
      dy += weight * (current[neighbour + 1] - y);
      dz += weight * (current[neighbour + 2] - z);
    }
    const step = steps[fan];
    const nextX = scale * (x + step * dx) - previous[i];
    const nextY = scale * (y + step * dy) - previous[i + 1];
    const nextZ = scale * (z + step * dz) - previous[i + 2];
    previous[i] = nextX;
    previous[i + 1] = nextY;
    previous[i + 2] = nextZ;
    for (let term = 0; term < terms.length; term++) {
      const { coefficient, result } = terms[term];
      result[i] += coefficient * nextX;
      result[i + 1] += coefficient * nextY;
      result[i + 2] += coefficient * nextZ;
    }
  }
}
