import { type Cells, type CoarseGraph, clusterNodes, coarsen, NONE } from '../adjacency/cells.js';
import { asPhase, forEachChunk, release } from '../phases.js';
import type { HeatEquation, HeatLevel } from './assembleHeatEquation.js';
import { orderBySize } from './sortFans.js';

/** Seeds of cells lie more than this many edges apart: a cell has about eight nodes. */
const RINGS = 2;

/** A level with known places. */
type PlacedHeat = HeatLevel & { places: Float32Array };

/** A coarser copy of a heat equation. */
export interface CoarseHeat extends PlacedHeat {
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
  yield* asPhase(
    forEachChunk(cells.ofNode.length, (start, end) => sumFluxes(heat, places, coarse.ofEntry, fluxes, start, end)),
    0.7,
    0.9,
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
