import { type Cells, type CoarseGraph, clusterNodes, coarsen, NONE } from '../adjacency/cells.js';
import { asPhase, chunkPhase, release } from '../phases.js';
import type { HeatEquation, HeatLevel } from './assembleHeatEquation.js';
import { orderBySize } from './fans.js';
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

/** Seeds of cells lie more than this many edges apart: a cell has about eight nodes. */
const RINGS = 2;

/** A level with known places. */
type PlacedHeat = HeatLevel & { places: Float32Array };

/** A coarser copy of a heat equation. */
interface CoarseHeat extends PlacedHeat {
  /** For each node of the finer equation its cell, which is a node of this one. */
  ofNode: Uint32Array;
}

/**
 * Makes a coarser copy of a heat equation, in which each cell of neighbouring nodes is one node. Between two cells as much heat flows as
 * between their nodes where temperature rises evenly (finite volumes with a two-point flux). With the sums of the nodes' weights alone,
 * heat would spread too fast by a factor of the width of a cell in nodes.
 */
export function* coarsenHeat({ heat, places, shares }: PlacedHeat): Generator<number, CoarseHeat, void> {
  const cells = yield* asPhase(clusterNodes(heat, RINGS), 0, 0.4);
  release(cells.order, cells.parents, cells.parentEntries);
  const coarse = yield* asPhase(coarsen(heat, cells), 0.4, 0.7);
  const { masses, centres } = centresOf(heat.masses, places, cells);
  const fluxes = new Float64Array(3 * coarse.neighbours.length);
  yield* chunkPhase(cells.ofNode.length, 0.7, 0.9, (start, end) =>
    sumFluxes(heat, places, coarse.ofEntry, fluxes, start, end),
  );
  const weights = weightsOf(coarse, centres, fluxes);
  release(coarse.ofEntry, fluxes);
  const cellShares = shares && Float32Array.from(cells.seeds, (seed) => shares[seed]);
  return yield* asPhase(sortCells({ cells, coarse, masses, centres, weights, cellShares }), 0.9, 1);
}

/** The mass of each cell and its centre of mass. A cell without mass has its seed as its centre. */
function centresOf(
  masses: Float64Array,
  places: Float32Array,
  { ofNode, seeds, count }: Cells,
): { masses: Float64Array<ArrayBuffer>; centres: Float64Array } {
  const sums = new Float64Array(count);
  const centres = new Float64Array(3 * count);
  for (let node = 0; node < ofNode.length; node++) {
    const cell = ofNode[node];
    const mass = masses[node];
    sums[cell] += mass;
    centres[3 * cell] += mass * places[3 * node];
    centres[3 * cell + 1] += mass * places[3 * node + 1];
    centres[3 * cell + 2] += mass * places[3 * node + 2];
  }
  for (let cell = 0; cell < count; cell++) {
    for (let k = 0; k < 3; k++) {
      const at = 3 * cell + k;
      centres[at] = sums[cell] > 0 ? centres[at] / sums[cell] : places[3 * seeds[cell] + k];
    }
  }
  return { masses: sums, centres };
}

/** Adds up, for each entry between two cells, the flux for temperatures equal to each of the three coordinates. */
function sumFluxes(
  { starts, neighbours, weights }: HeatEquation,
  places: Float32Array,
  ofEntry: Int32Array,
  fluxes: Float64Array,
  start: number,
  end: number,
): void {
  for (let node = start; node < end; node++) {
    for (let entry = starts[node]; entry < starts[node + 1]; entry++) {
      if (ofEntry[entry] === NONE) continue;
      const at = 3 * ofEntry[entry];
      const neighbour = 3 * neighbours[entry];
      const weight = weights[entry];
      fluxes[at] += weight * (places[3 * node] - places[neighbour]);
      fluxes[at + 1] += weight * (places[3 * node + 1] - places[neighbour + 1]);
      fluxes[at + 2] += weight * (places[3 * node + 2] - places[neighbour + 2]);
    }
  }
}

/** The weight of each entry between two cells: the flux per unit of their distance, or 0 where heat would flow from cold to warm. */
function weightsOf({ starts, neighbours }: CoarseGraph, centres: Float64Array, fluxes: Float64Array): Float32Array {
  const weights = new Float32Array(neighbours.length);
  for (let cell = 0; cell < starts.length - 1; cell++) {
    for (let entry = starts[cell]; entry < starts[cell + 1]; entry++) {
      const other = 3 * neighbours[entry];
      let squared = 0;
      let squaredFlux = 0;
      let along = 0;
      for (let k = 0; k < 3; k++) {
        const distance = centres[3 * cell + k] - centres[other + k];
        const flux = fluxes[3 * entry + k];
        squared += distance * distance;
        squaredFlux += flux * flux;
        along += distance * flux;
      }
      if (squared > 0 && along > 0) weights[entry] = Math.sqrt(squaredFlux / squared);
    }
  }
  return weights;
}

/** A coarse heat equation whose cells are in the order of their discovery. */
interface FoundCells {
  cells: Cells;
  coarse: CoarseGraph;
  masses: Float64Array;
  centres: Float64Array;
  weights: Float32Array;
  cellShares: Float32Array | undefined;
}

/** Sorts the cells by their number of edges, as `sortFans` does. */
function* sortCells({
  cells: { count, ofNode },
  coarse,
  masses,
  centres,
  weights,
  cellShares,
}: FoundCells): Generator<number, CoarseHeat, void> {
  const sizes = new Uint32Array(count);
  for (let cell = 0; cell < count; cell++) sizes[cell] = coarse.starts[cell + 1] - coarse.starts[cell];
  const order = yield* orderBySize(sizes, count);
  const numbers = new Uint32Array(count);
  for (let i = 0; i < count; i++) numbers[order[i]] = i;
  const heat = {
    starts: new Uint32Array(count + 1),
    neighbours: new Uint32Array(weights.length),
    weights: new Float32Array(weights.length),
    masses: new Float64Array(count),
    degrees: new Float64Array(count),
  };
  const places = new Float32Array(3 * count);
  let length = 0;
  for (let i = 0; i < count; i++) {
    const cell = order[i];
    for (let entry = coarse.starts[cell]; entry < coarse.starts[cell + 1]; entry++) {
      heat.neighbours[length] = numbers[coarse.neighbours[entry]];
      heat.weights[length] = weights[entry];
      heat.degrees[i] += weights[entry];
      length++;
    }
    heat.starts[i + 1] = length;
    heat.masses[i] = masses[cell];
    for (let k = 0; k < 3; k++) places[3 * i + k] = centres[3 * cell + k];
  }
  for (let node = 0; node < ofNode.length; node++) ofNode[node] = numbers[ofNode[node]];
  return { heat, places, shares: cellShares && Float32Array.from(order, (cell) => cellShares[cell]), ofNode };
}
