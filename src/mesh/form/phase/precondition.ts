import type { Cells } from '../../adjacency/cells.js';
import { forEachChunk } from '../../phases.js';
import { solveLastPart } from './lastLevel.js';
import { gatherJumps, type PhaseSystem, spreadJumps } from './PhaseSystem.js';
import { pullNodes, pullOffsets, residual, sweep } from './phaseOperator.js';

/**
 * Factor on coarse corrections. Values that are constant in each cell make the coarse matrix too stiff, by about the number of edges across
 * a cell.
 */
const OVERCORRECTION = 1.6;

/** Sweeps in each direction on the last level, for parts that are too large for a direct solver. */
const LAST_SWEEPS = 2;

/**
 * A V-cycle of multigrid: solves system · values = forces roughly, by sweeps and by corrections from all coarser levels. It is
 * linear and symmetric, as conjugate gradients need it. `forces` of the level's buffers are read, `values` written, `rest` is used.
 */
export function* precondition(system: PhaseSystem): Generator<number, void, void> {
  const { levels, buffers, level, seamBuffers } = system;
  const { matrix, cells } = levels[level];
  const { forces, values, rest } = buffers[level];
  if (!cells) {
    yield* sweepLastLevel(system);
    for (const part of system.lastParts) solveLastPart(part, forces, values, system.isFree && !system.held);
    return;
  }
  values.nodes.fill(0);
  yield* sweep(matrix, forces.nodes, values.nodes, 1);
  yield* residual(matrix, forces.nodes, values.nodes, rest.nodes);
  const coarse = buffers[level + 1];
  coarse.forces.nodes.fill(0);
  yield* restrict(cells, rest.nodes, coarse.forces.nodes);
  if (system.isFree) {
    seamBuffers.offsets.fill(0);
    pullOffsets(matrix.seam, values.nodes, seamBuffers.offsets, seamBuffers.pulls);
    gatherJumps(system, rest.jumps);
    for (let i = 0; i < rest.jumps.length; i++) coarse.forces.jumps[i] = forces.jumps[i] - rest.jumps[i];
  }
  yield* precondition({ ...system, level: level + 1 });
  yield* forEachChunk(cells.ofNode.length, (start, end) =>
    correctRange(cells.ofNode, coarse.values.nodes, values.nodes, start, end),
  );
  if (!system.isFree) {
    yield* sweep(matrix, forces.nodes, values.nodes, -1);
    return;
  }
  for (let i = 0; i < values.jumps.length; i++) values.jumps[i] = OVERCORRECTION * coarse.values.jumps[i];
  spreadJumps(system, values.jumps);
  rest.nodes.set(forces.nodes);
  pullNodes(matrix.seam, seamBuffers.offsets, -1, rest.nodes);
  yield* sweep(matrix, rest.nodes, values.nodes, -1);
}

/** Solves the last level approximately, by sweeps over the nodes; jumps are solved one by one. */
function* sweepLastLevel({ levels, buffers, level, jumpDiagonal }: PhaseSystem): Generator<number, void, void> {
  const { matrix } = levels[level];
  const { forces, values } = buffers[level];
  values.nodes.fill(0);
  for (let i = 0; i < LAST_SWEEPS; i++) yield* sweep(matrix, forces.nodes, values.nodes, 1);
  for (let i = 0; i < LAST_SWEEPS; i++) yield* sweep(matrix, forces.nodes, values.nodes, -1);
  for (let i = 0; i < values.jumps.length; i++) values.jumps[i] = forces.jumps[i] / jumpDiagonal[i >> 1];
}

/** Adds the values of nodes to those of their cells. */
export function* restrict(
  { ofNode }: Cells,
  values: Float64Array,
  coarse: Float64Array,
): Generator<number, void, void> {
  yield* forEachChunk(ofNode.length, (start, end) => restrictRange(ofNode, values, coarse, start, end));
}

function restrictRange(
  ofNode: Uint32Array,
  values: Float64Array,
  coarse: Float64Array,
  start: number,
  end: number,
): void {
  for (let node = start; node < end; node++) {
    coarse[2 * ofNode[node]] += values[2 * node];
    coarse[2 * ofNode[node] + 1] += values[2 * node + 1];
  }
}

function correctRange(
  ofNode: Uint32Array,
  coarse: Float64Array,
  values: Float64Array,
  start: number,
  end: number,
): void {
  for (let node = start; node < end; node++) {
    values[2 * node] += OVERCORRECTION * coarse[2 * ofNode[node]];
    values[2 * node + 1] += OVERCORRECTION * coarse[2 * ofNode[node] + 1];
  }
}
