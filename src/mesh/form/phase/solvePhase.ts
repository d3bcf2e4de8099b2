import type { Cells } from '../../adjacency/cells.js';
import { asPhase, release } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FormSurface } from '../FormSurface.js';
import { conjugateGradients, type FreeForces, type Patience, solveFree } from './conjugateGradients.js';
import { factoriseLastLevel } from './lastLevel.js';
import { type PhaseSystem, type PhaseVector, phaseSystem, spreadJumps } from './PhaseSystem.js';
import type { PhaseLevel } from './phaseLevels.js';
import { pullNodes, pullOffsets, residual } from './phaseOperator.js';
import type { PhaseSource } from './phaseSource.js';
import { restrict } from './precondition.js';
import { riseInCells } from './riseInCells.js';
import { roundJumps } from './roundJumps.js';
import type { SeamRelations } from './seamRelations.js';

/** Jumps are rounded on the finest level with at most this many nodes. Finer levels would hardly change the result. */
const MOST_NODES_TO_ROUND = 12_000;

/** Stopping criteria of the last level, which starts from zero. */
const LAST_LEVEL: Patience = { tolerance: 1e-3, steps: 200 };

/** Stopping criteria of the other levels, which start from the level before. */
const FREE_JUMPS: Patience = { tolerance: 1e-2, steps: 30 };
const WHOLE_JUMPS: Patience = { tolerance: 0.03, steps: 6 };

/** The solution: φ and φ₂ side by side. */
export interface Phase {
  /** Two values for each fan. */
  nodes: Float64Array;
  /** Two values for each offset. */
  offsets: Float64Array;
}

/** The right side of one level, and the height of each node above the seed of its cell. */
interface LevelForces extends FreeForces {
  rises: Float64Array;
}

/**
 * Solves for φ and φ₂, first on the last level, then on each finer one from the solution of the level before. A cell has the value of its
 * seed; its other nodes lie higher by the rise of φ on the way there. Jumps are unknowns at first. Once a level is fine enough they are
 * rounded to multiples of whole numbers, so that lines continue across the cut, and are given from then on.
 *
 * @param levels their cells are freed
 * @param source its slopes are freed
 */
export function* solvePhase(
  surface: FormSurface,
  seam: FormSeam,
  relations: SeamRelations,
  levels: readonly PhaseLevel[],
  source: PhaseSource,
): Generator<number, Phase, void> {
  const coarsest = phaseSystem(relations, levels);
  const lastParts = yield* asPhase(factoriseLastLevel(coarsest), 0, 0);
  const forces: LevelForces[] = [];
  for (const [i, level] of levels.entries()) {
    const above = i === 0 ? source : yield* asPhase(restrictForces({ ...coarsest, level: i - 1 }, forces[i - 1]), 0, 0);
    const rises = yield* asPhase(riseInCells(surface, seam, source.slopes, level), 0, 0);
    forces.push({ nodes: above.forces, offsets: above.offsetForces, rises });
    if (level.cells) release(level.cells.order, level.cells.parents, level.cells.parentEntries);
  }
  release(source.slopes);
  const last = levels.length - 1;
  const roundAt = levels.findIndex(({ fans }, i) => i === last || fans.length <= MOST_NODES_TO_ROUND);
  let x: PhaseVector = {
    nodes: new Float64Array(2 * levels[last].fans.length),
    jumps: new Float64Array(2 * relations.jumps.free.length),
  };
  for (let level = last; level >= 0; level--) {
    const { cells, fans } = levels[level];
    if (cells) x = { nodes: prolong(cells, x.nodes, forces[level].rises), jumps: x.jumps };
    const system = { ...coarsest, lastParts, level };
    // Each level takes as long as all coarser ones together, or longer.
    const begun = (0.4 * fans.length) / levels[0].fans.length;
    if (level >= roundAt) {
      const patience = level === last ? LAST_LEVEL : FREE_JUMPS;
      yield* asPhase(solveFree(system, forces[level], x, patience), begun, begun);
    }
    if (level === roundAt) yield* asPhase(roundJumps(system, forces[level], x), begun, begun);
    if (level <= roundAt) yield* asPhase(solveGiven(system, forces[level], x), begun, begun);
  }
  return { nodes: x.nodes, offsets: coarsest.seamBuffers.offsets };
}

/** The right side of the next level: the residual on the cells when their nodes rise as they should. */
function* restrictForces(
  { levels, buffers, seamBuffers, level }: PhaseSystem,
  { nodes, offsets, rises }: LevelForces,
): Generator<number, Pick<PhaseSource, 'forces' | 'offsetForces'>, void> {
  const { matrix, cells } = levels[level];
  const rest = buffers[level].rest.nodes;
  const coarse = new Float64Array(2 * levels[level + 1].fans.length);
  yield* residual(matrix, nodes, rises, rest);
  yield* restrict(cells!, rest, coarse);
  seamBuffers.offsets.fill(0);
  pullOffsets(matrix.seam, rises, seamBuffers.offsets, seamBuffers.pulls);
  return { forces: coarse, offsetForces: offsets.map((force, i) => force - seamBuffers.pulls[i]) };
}

/** Solves for the nodes alone. Overwrites the forces. */
function* solveGiven(system: PhaseSystem, { nodes }: LevelForces, x: PhaseVector): Generator<number, void, void> {
  const { seam } = system.levels[system.level].matrix;
  spreadJumps(system, x.jumps);
  pullNodes(seam, system.seamBuffers.offsets, -1, nodes);
  yield* conjugateGradients({ ...system, isFree: false }, { nodes, jumps: x.jumps }, x, WHOLE_JUMPS);
}

/** The values of nodes: those of the seeds of their cells, plus their rises. */
function prolong({ ofNode }: Cells, coarse: Float64Array, rises: Float64Array): Float64Array {
  const values = new Float64Array(rises.length);
  for (let node = 0; node < ofNode.length; node++) {
    values[2 * node] = coarse[2 * ofNode[node]] + rises[2 * node];
    values[2 * node + 1] = coarse[2 * ofNode[node] + 1] + rises[2 * node + 1];
  }
  return values;
}
