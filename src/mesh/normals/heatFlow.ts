import { release } from '../phases.js';
import type { HeatEquation } from './assembleHeatEquation.js';

/** Largest rate of mixing, as a multiple of the mean rate. Nodes of very small triangles are slowed down to it. */
const LARGEST_RATE = 2;

/** Largest number of nodes per run of a pass. */
const LONGEST_RUN = 1 << 13;

/** Runs between two yields. */
const RUNS_PER_YIELD = 4;

/** The highest rate at which a node mixes with its neighbours, limited by LARGEST_RATE. */
export function highestRate({ masses, degrees }: HeatEquation): number {
  let highest = 0;
  let massSum = 0;
  let degreeSum = 0;
  for (let node = 0; node < masses.length; node++) {
    if (masses[node] === 0) continue;
    highest = Math.max(highest, degrees[node] / masses[node]);
    massSum += masses[node];
    degreeSum += degrees[node];
  }
  return massSum === 0 ? 0 : Math.min(highest, (LARGEST_RATE * degreeSum) / massSum);
}

/** The matrix 2P, whose entries off the diagonal lie as those of the heat equation. */
export interface Mixing extends Pick<HeatEquation, 'starts' | 'neighbours'> {
  /** The entries on the diagonal. Each makes the sum of its row 2. */
  owns: Float64Array;
  weights: Float32Array;
}

/** Increases, in place, the mass of nodes that would mix faster than the rate. */
export function limitRate({ masses, degrees }: HeatEquation, rate: number): void {
  for (let node = 0; node < masses.length; node++) masses[node] = Math.max(masses[node], degrees[node] / rate);
}

/** Computes 2P in place of the weights and degrees of the heat equation. No node mixes faster than the rate, so the eigenvalues of P lie within [−1, 1]. */
export function twiceP(
  { starts, neighbours, weights, masses, degrees }: HeatEquation,
  rate: number,
  shares: Float32Array | undefined,
): Mixing {
  for (let node = 0; node < degrees.length; node++) {
    let step = 2 / (rate * masses[node] || 1);
    // Heat spreads over a share of the radius in that share, squared, of the time.
    if (shares) step *= shares[node] ** 2;
    let own = 2;
    for (let edge = starts[node]; edge < starts[node + 1]; edge++) {
      weights[edge] *= step;
      own -= weights[edge];
    }
    degrees[node] = own;
  }
  return { starts, neighbours, owns: degrees, weights };
}

/**
 * Computes Σ cₖ·Tₖ(P)·values for each series of coefficients cₖ, where P = 1 − L/rate and L is the Laplacian, by the recurrence
 * of the Chebyshev polynomials. With the coefficients of `heatSeries` that is e^(−steps·(1 − P))·values.
 * `values` are lost.
 */
export function* flow(
  matrix: Mixing,
  values: Float32Array<ArrayBuffer>,
  series: readonly (readonly number[])[],
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const nodeCount = matrix.owns.length;
  const results = series.map(([first]) => scaled(values, first));
  const lengths = series.map(({ length }) => length);
  const longest = lengths.indexOf(Math.max(...lengths));
  const passes = lengths[longest] - 1;
  const runs = findRuns(matrix.starts);
  let current = values;
  let previous = new Float32Array(values.length);
  for (let k = 1; k <= passes; k++) {
    // T₁ = P·T₀, but a step gives 2P·T₀.
    const share = k === 1 ? 0.5 : 1;
    for (let run = 0, start = 0; run < runs.length; run++) {
      const end = runs[run];
      // The longest series is added within the pass, which was measured to take a fifth less than a separate loop.
      stepRun(matrix, current, previous, share * series[longest][k], results[longest], start, end);
      for (let i = 0; i < series.length; i++) {
        if (i === longest || k >= lengths[i]) continue;
        addRange(previous, share * series[i][k], results[i], 3 * start, 3 * end);
      }
      if (run % RUNS_PER_YIELD === 0) yield (k - 1 + end / nodeCount) / passes;
      start = end;
    }
    if (k === 1) for (let i = 0; i < previous.length; i++) previous[i] *= share;
    [current, previous] = [previous, current];
  }
  release(current, previous);
  return results;
}

/** Multiplies values by a factor. `map` calls a function for each value, which was measured to be ten times as slow. */
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
 * The ends of the runs of nodes with equally many edges. Branch prediction works best on loops of constant length: taking runs one by one
 * was measured to save a third of the time of a pass.
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
 * Turns `previous`, which holds Tₖ₋₁, into Tₖ₊₁ = 2P·Tₖ − Tₖ₋₁ for a run of nodes, and adds it to `result`. Sums are of double
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
  for (let node = start, i = 3 * start; node < end; node++, i += 3) {
    const own = owns[node];
    let x = own * current[i] - previous[i];
    let y = own * current[i + 1] - previous[i + 1];
    let z = own * current[i + 2] - previous[i + 2];
    for (const last = edge + size; edge < last; edge++) {
      const neighbour = Math.imul(3, neighbours[edge]);
      const weight = weights[edge];
      x += weight * current[neighbour];
      y += weight * current[neighbour + 1];
      z += weight * current[neighbour + 2];
    }
    previous[i] = x;
    previous[i + 1] = y;
    previous[i + 2] = z;
    // Rounded to single precision, as in `addRange`.
    result[i] += coefficient * Math.fround(x);
    result[i + 1] += coefficient * Math.fround(y);
    result[i + 2] += coefficient * Math.fround(z);
  }
}
