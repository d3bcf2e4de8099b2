import { asPhase, release } from '../phases.js';
import type { HeatLevel } from './assembleHeatEquation.js';
import { type CoarseHeat, coarsenHeat } from './coarsenHeat.js';
import { flow, highestRate, limitRate, twiceP } from './heatFlow.js';

/**
 * The coefficients c₀, c₁, … of e^(−time·(1 − x)) ≈ Σ cₖ·Tₖ(x) on [−1, 1], with Tₖ the Chebyshev polynomials. They are modified
 * Bessel functions of the first kind: c₀ ∝ I₀(time), cₖ ∝ 2·Iₖ(time). They fall off beyond k ≈ √time. The series ends where
 * the remaining coefficients sum to less than `tolerance`. The coefficients are scaled to sum to 1, so a constant keeps its
 * value.
 *
 * If x is a matrix of weighted means, the series gives the result of `time` small steps of heat flow in only about
 * √(2·time·ln(1/tolerance)) steps.
 */
export function heatSeries(time: number, tolerance: number): number[] {
  // Miller's algorithm: the recurrence I(k−1) = I(k+1) + 2k/time·I(k) is stable downwards, from any small value.
  const values: number[] = [];
  let last = 0;
  let value = 1e-150;
  for (let k = Math.ceil(Math.sqrt(40 * time)) + 8; k > 0; k--) {
    [last, value] = [value, last + ((2 * k) / time) * value];
    values[k - 1] = value;
  }
  const coefficients = values.map((bessel, k) => (k === 0 ? 1 : 2) * bessel);
  const total = sum(coefficients);
  let rest = 0;
  while (rest + coefficients.at(-1)! < tolerance * total) rest += coefficients.pop()!;
  const kept = sum(coefficients);
  return coefficients.map((coefficient) => coefficient / kept);
}

const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);

/** The share of the finest noise that may remain. */
const TOLERANCE = 0.02;

/** Heat that spreads for more steps takes most of them on a coarser copy. This many take some 50 passes. */
const MOST_STEPS = 320;

/**
 * Steps before a coarser copy, so that it resolves what is left, and after it, to remove the pattern of its cells: enough for a radius of
 * two or three edges, in nine passes each.
 */
const OVERLAP_STEPS = 10;

/** Whether heat that spreads for this many steps spreads over many nodes. */
export const isFar = (steps: number): boolean => steps > MOST_STEPS;

/**
 * Diffuses vectors like heat, for each of several times. Long times are mostly computed on a coarser copy of the surface, and on a copy of
 * that, so that the cost is proportional to the number of nodes (multigrid).
 *
 * Weights and degrees of the equation are overwritten, and so are the values.
 *
 * @param values three for each node
 * @returns the values after each time
 */
export function* diffuse(
  level: HeatLevel,
  values: Float32Array<ArrayBuffer>,
  times: readonly number[],
): Generator<number, Float32Array<ArrayBuffer>[], void> {
  const rate = highestRate(level.heat);
  if (rate > 0) limitRate(level.heat, rate);
  const results = times.map(() => values);
  const flowing = [...times.keys()].filter((i) => times[i] * rate > 1e-6);
  const { places } = level;
  const far = places ? flowing.filter((i) => isFar(times[i] * rate)) : [];
  const near = flowing.filter((i) => !far.includes(i));
  const coarse = places && far.length > 0 ? yield* asPhase(coarsenHeat({ ...level, places }), 0, 0.2) : undefined;
  const matrix = twiceP(level.heat, rate, level.shares);
  const overlap = heatSeries(OVERLAP_STEPS, TOLERANCE);
  const series = near.map((i) => heatSeries(times[i] * rate, TOLERANCE));
  // The result for a time too short for a step is the values themselves.
  const start = flowing.length === times.length ? values : values.slice();
  const [from, to] = coarse ? [0.2, 0.5] : [0, 1];
  const flowed = yield* asPhase(flow(matrix, start, coarse ? [...series, overlap] : series), from, to);
  for (const [k, i] of near.entries()) results[i] = flowed[k];
  if (!coarse) return results;
  const left = far.map((i) => times[i] - (2 * OVERLAP_STEPS) / rate);
  const means = meansOf(flowed.at(-1)!, level.heat.masses, coarse);
  release(flowed.at(-1)!);
  const onCells = yield* asPhase(diffuse(coarse, means, left), 0.5, 0.7);
  for (const [k, i] of far.entries()) {
    const smoothing = flow(matrix, onNodes(onCells[k], coarse), [overlap]);
    [results[i]] = yield* asPhase(smoothing, 0.7 + (0.3 * k) / far.length, 0.7 + (0.3 * (k + 1)) / far.length);
  }
  return results;
}

/** The means of the values over each cell, weighted by the masses of the nodes. */
function meansOf(values: Float32Array, masses: Float64Array, { ofNode, heat }: CoarseHeat): Float32Array<ArrayBuffer> {
  const sums = new Float64Array(3 * heat.masses.length);
  for (let node = 0; node < ofNode.length; node++) {
    const cell = 3 * ofNode[node];
    const mass = masses[node];
    sums[cell] += mass * values[3 * node];
    sums[cell + 1] += mass * values[3 * node + 1];
    sums[cell + 2] += mass * values[3 * node + 2];
  }
  const means = new Float32Array(sums.length);
  for (let cell = 0, i = 0; i < means.length; cell++) {
    const mass = heat.masses[cell] || 1;
    for (const end = i + 3; i < end; i++) means[i] = sums[i] / mass;
  }
  return means;
}

/** Gives each node the values of its cell. */
function onNodes(values: Float32Array, { ofNode }: CoarseHeat): Float32Array<ArrayBuffer> {
  const spread = new Float32Array(3 * ofNode.length);
  for (let node = 0; node < ofNode.length; node++) {
    const cell = 3 * ofNode[node];
    spread[3 * node] = values[cell];
    spread[3 * node + 1] = values[cell + 1];
    spread[3 * node + 2] = values[cell + 2];
  }
  return spread;
}
