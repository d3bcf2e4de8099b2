import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from './assembleHeatEquation.js';
import { heatSeries, longestHeatTime } from './heatSeries.js';
import { meanNormals } from './meanNormals.js';
import { sortFans } from './sortFans.js';

/** The largest rate of mixing, as a multiple of the mean rate. Fans of very small triangles are slowed down to it. */
const LARGEST_RATE = 2;

/** The share of the finest noise that may remain. */
const TOLERANCE = 0.02;

/**
 * The largest number of passes. It is enough for a radius of 40 mean edges, three times what scans need; more passes would take
 * seconds on a million triangles.
 */
const MAX_PASSES = 200;

/** The largest number of fans that a pass takes at once. */
const LONGEST_RUN = 1 << 13;

/** How many of those are taken between two yields. */
const RUNS_PER_YIELD = 4;

/**
 * Smooths normals at the scale of each of `radii`, in object units. The mean normal of each fan diffuses over the surface like
 * heat, for the time radius²/4, in which heat spreads over about `radius`. Finer noise is averaged away; nothing flows across
 * edges that separate fans. The result depends on the shape and not on its triangulation, thanks to cotangent weights and a
 * time in object units instead of a number of passes.
 *
 * Several radii cost little more than the largest of them, because they are parts of one flow.
 *
 * @param shares for each fan the share of the radii that is used around it, at most 1. Default: 1 everywhere
 * @returns for each radius a vector per fan (x, y, z), not of unit length. It is zero where normals cancel and for fans that
 *   only have degenerate triangles.
 */
export function* smoothFanNormals(
  surface: FanSurface,
  radii: readonly number[],
  shares?: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const { order, ...flow } = yield* asPhase(startFlow(surface), 0, 0.25);
  const results = yield* asPhase(diffuse(flow, radii, shares && gathered(shares, order)), 0.25, 0.98);
  return yield* asPhase(inOrderOfFans(results, order), 0.98, 1);
}

/** The mean normal of each fan, three floats, and the equation by which they diffuse. */
interface NormalFlow {
  normals: Float32Array<ArrayBuffer>;
  heat: HeatEquation;
}

/** Prepares `diffuse`. What is needed only for that is free when the normals diffuse. `order` is that of `sortFans`. */
function* startFlow(surface: FanSurface): Generator<number, NormalFlow & { order: Uint32Array<ArrayBuffer> }, void> {
  const sorted = yield* asPhase(sortFans(surface), 0, 0.2);
  const { normals, masses } = yield* asPhase(meanNormals(surface, sorted), 0.2, 0.4);
  return { order: sorted.order, normals, heat: yield* asPhase(assembleHeatEquation(surface, masses, sorted), 0.4, 1) };
}

/** Lets normals diffuse. Weights and degrees of `heat` are lost. */
function* diffuse(
  { normals, heat }: NormalFlow,
  radii: readonly number[],
  shares: Float32Array | undefined,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const smoothed = radii.map(() => normals);
  const flows = planFlows(radii, highestRate(heat));
  for (const [i, { rate, parts }] of flows.entries()) {
    const series = parts.map(({ steps }) => heatSeries(steps, TOLERANCE));
    // The last flow overwrites what the others have copied.
    const isLast = i === flows.length - 1;
    const kept = isLast ? heat : { ...heat, weights: heat.weights.slice(), degrees: heat.degrees.slice() };
    const matrix = twiceP(kept, rate, shares);
    const task = flow(matrix, isLast && parts.length === radii.length ? normals : normals.slice(), series);
    const results = yield* asPhase(task, i / flows.length, (i + 1) / flows.length);
    for (const [k, { radius }] of parts.entries()) smoothed[radius] = results[k];
  }
  return smoothed;
}

const gathered = (values: Float32Array, order: Uint32Array): Float32Array<ArrayBuffer> => {
  const result = new Float32Array(values.length);
  for (let i = 0; i < values.length; i++) result[i] = values[order[i]];
  return result;
};

/** Puts vectors back into the order that fans had before they were sorted. Radii that share a result go on sharing it. */
function* inOrderOfFans(
  results: readonly Float32Array[],
  order: Uint32Array,
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const targets = new Map<Float32Array, Float32Array<ArrayBuffer>>();
  for (const result of new Set(results)) {
    const target = new Float32Array(result.length);
    targets.set(result, target);
    yield* forEachChunk(order.length, (start, end) => scatterVectors(result, order, target, start, end));
  }
  return results.map((result) => targets.get(result)!);
}

function scatterVectors(
  vectors: Float32Array,
  order: Uint32Array,
  target: Float32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const fan = 3 * order[i];
    target[fan] = vectors[3 * i];
    target[fan + 1] = vectors[3 * i + 1];
    target[fan + 2] = vectors[3 * i + 2];
  }
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
 * of the Chebyshev polynomials. With the coefficients of `heatSeries` that is e^(−steps·(1 − P))·normals.
 * Overwrites `normals`.
 */
function* flow(
  matrix: Mixing,
  normals: Float32Array<ArrayBuffer>,
  series: readonly (readonly number[])[],
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const fanCount = matrix.owns.length;
  const results = series.map(([first]) => scaled(normals, first));
  const lengths = series.map(({ length }) => length);
  const longest = lengths.indexOf(Math.max(...lengths));
  const passes = lengths[longest] - 1;
  const runs = findRuns(matrix.starts);
  let current = normals;
  let previous = new Float32Array(normals.length);
  for (let k = 1; k <= passes; k++) {
    // T₁ = P·T₀, but a step gives 2P·T₀.
    const share = k === 1 ? 0.5 : 1;
    for (let run = 0, start = 0; run < runs.length; run++) {
      const end = runs[run];
      // The longest series comes with the pass itself: it was measured to take a fifth less than a walk of its own.
      stepRun(matrix, current, previous, share * series[longest][k], results[longest], start, end);
      for (let i = 0; i < series.length; i++) {
        if (i === longest || k >= lengths[i]) continue;
        addRange(previous, share * series[i][k], results[i], 3 * start, 3 * end);
      }
      if (run % RUNS_PER_YIELD === 0) yield (k - 1 + end / fanCount) / passes;
      start = end;
    }
    if (k === 1) previous = scaled(previous, share);
    [current, previous] = [previous, current];
  }
  return results;
}

/** The matrix 2P, whose entries off the diagonal lie as those of the heat equation. */
interface Mixing extends Pick<HeatEquation, 'starts' | 'neighbours'> {
  /** The entries on the diagonal. Each makes the sum of its row 2. */
  owns: Float64Array;
  weights: Float32Array;
}

/**
 * Computes 2P in place of the weights and degrees of the heat equation. A fan with so little area that it would mix faster than the
 * rate is treated as larger, which keeps the eigenvalues of P within [−1, 1].
 */
function twiceP(
  { starts, neighbours, weights, masses, degrees }: HeatEquation,
  rate: number,
  shares: Float32Array | undefined,
): Mixing {
  for (let fan = 0; fan < degrees.length; fan++) {
    let step = 2 / (Math.max(rate * masses[fan], degrees[fan]) || 1);
    // Heat spreads over a share of the radius in that share, squared, of the time.
    if (shares) step *= shares[fan] ** 2;
    let own = 2;
    for (let edge = starts[fan]; edge < starts[fan + 1]; edge++) {
      weights[edge] *= step;
      own -= weights[edge];
    }
    degrees[fan] = own;
  }
  return { starts, neighbours, owns: degrees, weights };
}

/** Multiplies values by a factor. `map` would call a function for each value, which was measured to be ten times as slow. */
function scaled(values: Float32Array, factor: number): Float32Array<ArrayBuffer> {
  const result = new Float32Array(values.length);
  for (let i = 0; i < values.length; i++) result[i] = factor * values[i];
  return result;
}

/** Adds a term to a range of the result of a series. */
function addRange(term: Float32Array, coefficient: number, result: Float32Array, start: number, end: number): void {
  for (let i = start; i < end; i++) result[i] += coefficient * term[i];
}

/**
 * The ends of the runs of fans that have equally many edges. A processor guesses well how often a loop is repeated if it is always
 * the same number, so a pass takes runs one by one: that was measured to save a third of its time.
 */
function findRuns(starts: Uint32Array): Uint32Array {
  const ends: number[] = [];
  const count = starts.length - 1;
  for (let first = 0; first < count; ) {
    const size = starts[first + 1] - starts[first];
    const longest = Math.min(first + LONGEST_RUN, count);
    let end = first + 1;
    while (end < longest && starts[end + 1] - starts[end] === size) end++;
    ends.push(end);
    first = end;
  }
  return Uint32Array.from(ends);
}

/**
 * Turns `previous`, which holds Tₖ₋₁, into Tₖ₊₁ = 2P·Tₖ − Tₖ₋₁ for a run of fans, and adds it to `result`. Sums are of double
 * precision and rounded once, so equal neighbours stay equal to the last bit.
 */
function stepRun(
  { starts, neighbours, owns, weights }: Mixing,
  current: Float32Array,
  previous: Float32Array,
  coefficient: number,
  result: Float32Array,
  start: number,
  end: number,
): void {
  let edge = starts[start];
  const size = starts[end] - starts[end - 1];
  for (let fan = start, i = 3 * start; fan < end; fan++, i += 3) {
    const own = owns[fan];
    let x = own * current[i] - previous[i];
    let y = own * current[i + 1] - previous[i + 1];
    let z = own * current[i + 2] - previous[i + 2];
    for (const last = edge + size; edge < last; edge++) {
      const neighbour = neighbours[edge];
      const weight = weights[edge];
      x += weight * current[neighbour];
      y += weight * current[neighbour + 1];
      z += weight * current[neighbour + 2];
    }
    previous[i] = x;
    previous[i + 1] = y;
    previous[i + 2] = z;
    // Rounded, as `addRange` would find it.
    result[i] += coefficient * Math.fround(x);
    result[i + 1] += coefficient * Math.fround(y);
    result[i + 2] += coefficient * Math.fround(z);
  }
}
