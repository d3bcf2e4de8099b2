import type { Cells } from '../../adjacency/cells.js';
import { asPhase, forEachChunk, release } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FormSurface } from '../FormSurface.js';
import { conjugateGradients, type FreeForces, type Patience, solveFree } from './conjugateGradients.js';
import {
  type LastPart,
  type PhaseSystem,
  type PhaseVector,
  phaseSystem,
  pullNodes,
  pullOffsets,
  residual,
  spreadJumps,
} from './PhaseSystem.js';
import type { PhaseLevel } from './phaseLevels.js';
import { type PhaseSource, SLOPE_FLOATS } from './phaseSource.js';
import { factoriseLastLevel, restrict } from './precondition.js';
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

/**
 * Computes by how much φ and φ₂ should rise from the seed of its cell to each node of a level, along the path on which the cell
 * has grown.
 *
 * @param slopes see `PhaseSource`
 */
function* riseInCells(
  surface: Pick<FormSurface, 'mesh'>,
  seam: Pick<FormSeam, 'cornerOf'>,
  slopes: Float32Array,
  level: PhaseLevel,
): Generator<number, Float64Array, void> {
  const { fans, cells } = level;
  const rises = new Float64Array(2 * fans.length);
  if (cells) {
    yield* forEachChunk(fans.length, (start, end) =>
      riseRange(surface, seam, slopes, fans, cells.order, cells.parents, rises, start, end),
    );
  }
  return rises;
}

/** Each node comes after its parent. */
function riseRange(
  { mesh: { positions, indices } }: Pick<FormSurface, 'mesh'>,
  { cornerOf }: Pick<FormSeam, 'cornerOf'>,
  slopes: Float32Array,
  fans: Uint32Array,
  order: Uint32Array,
  parents: Int32Array,
  rises: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const node = order[i];
    const parent = parents[node];
    if (parent < 0) continue;
    const from = 3 * indices[cornerOf[fans[parent]]];
    const to = 3 * indices[cornerOf[fans[node]]];
    const x = 0.5 * (positions[to] - positions[from]);
    const y = 0.5 * (positions[to + 1] - positions[from + 1]);
    const z = 0.5 * (positions[to + 2] - positions[from + 2]);
    const a = SLOPE_FLOATS * fans[parent];
    const b = SLOPE_FLOATS * fans[node];
    rises[2 * node] =
      rises[2 * parent] +
      (slopes[a] + slopes[b]) * x +
      (slopes[a + 1] + slopes[b + 1]) * y +
      (slopes[a + 2] + slopes[b + 2]) * z;
    rises[2 * node + 1] =
      rises[2 * parent + 1] +
      (slopes[a + 3] + slopes[b + 3]) * x +
      (slopes[a + 4] + slopes[b + 4]) * y +
      (slopes[a + 5] + slopes[b + 5]) * z;
  }
}

/**
 * Jumps of φ are multiples of four, those of φ₂ of two, so that every fourth line, and every second of those that cross, continues across
 * the cut: no more are left where an object is small. Larger multiples would bend lines, most of all along thin limbs, around which φ₂
 * rises by little.
 */
export const MULTIPLES = [4, 2] as const;

/** Largest share of its energy that rounding may add to a part; otherwise its jumps are rounded to smaller multiples. */
const MOST_MOVED = 0.2;

/** The share of the jumps rounded in each turn. The last few are rounded together. */
const SHARE_OF_TURN = 0.5;
const LAST_TURN = 16;

/** Stopping criteria for the unknowns that follow rounded jumps: they need not move far. */
const FOLLOWING = { tolerance: 1e-2, steps: 20 };

/**
 * Rounds the jumps of a solution to the multiples of their family, in place. Parts with a direct solver are rounded there. All other jumps
 * take turns: the half nearest to its multiples is rounded, and the rest is solved again before the next half is. The families are
 * independent.
 */
export function* roundJumps(system: PhaseSystem, forces: FreeForces, x: PhaseVector): Generator<number, void, void> {
  const held = new Uint8Array(x.jumps.length);
  roundParts(system.lastParts, x.jumps, held);
  while (roundNearest(x.jumps, held) > 0) yield* solveFree({ ...system, held }, forces, x, FOLLOWING);
}

/** Rounds the jumps of each family that are nearest to their multiples. Returns the number of those left. */
function roundNearest(jumps: Float64Array, held: Uint8Array): number {
  let left = 0;
  for (const [family, multiple] of MULTIPLES.entries()) {
    const loose = [...held.keys()].filter((i) => i % 2 === family && held[i] === 0);
    const distances = jumps.map((jump) => Math.abs(jump - roundTo(multiple, jump)));
    loose.sort((i, j) => distances[i] - distances[j] || i - j);
    const count = loose.length <= LAST_TURN ? loose.length : Math.ceil(SHARE_OF_TURN * loose.length);
    for (const i of loose.slice(0, count)) {
      jumps[i] = roundTo(multiple, jumps[i]);
      held[i] = 1;
    }
    left += loose.length - count;
  }
  return left;
}

/**
 * Rounds the jumps of parts to the multiples of their family, in place; those of a part that is too small for that to smaller multiples.
 *
 * @param held for each value of a jump 1 if it is rounded; those of the parts are set
 */
export function roundParts(parts: readonly LastPart[], jumps: Float64Array, held: Uint8Array): void {
  for (const part of parts) {
    for (const [family, multiple] of MULTIPLES.entries()) {
      const places = part.jumps.map((jump) => 2 * jump + family);
      const given = places.map((place) => jumps[place]);
      for (const [i, value] of roundedPart(part, given, multiple).entries()) {
        jumps[places[i]] = value;
        held[places[i]] = 1;
      }
    }
  }
}

const roundTo = (multiple: number, jump: number): number => multiple * Math.round(jump / multiple);

/** The jumps of a part, rounded to `multiple`, or to a smaller power of two if little would be left of them. */
function roundedPart(part: LastPart, given: readonly number[], multiple: number): number[] {
  const rounded = nearestPlane(part, given, multiple);
  const moves = rounded.map((value, i) => value - given[i]);
  const isFar = jumpEnergy(part, moves) > MOST_MOVED * jumpEnergy(part, given);
  return multiple > 1 && isFar ? roundedPart(part, given, multiple / 2) : rounded;
}

/**
 * Rounds dependent jumps: where one has been rounded up, the next follows it before it is rounded. This is Babai's nearest plane, for the
 * energy of the jumps after all nodes have been eliminated (the last rows of L).
 */
function nearestPlane(part: LastPart, given: readonly number[], multiple: number): number[] {
  const rounded = given.slice();
  const moves = given.map(() => 0);
  for (let i = given.length - 1; i >= 0; i--) {
    rounded[i] = roundTo(multiple, given[i] - jumpForce(part, moves, i) * part.inverses[part.nodes.length + i]);
    moves[i] = rounded[i] - given[i];
  }
  return rounded;
}

const jumpEnergy = (part: LastPart, jumps: readonly number[]): number =>
  jumps.reduce((sum, _, i) => sum + jumpForce(part, jumps, i) ** 2, 0);

/** Entry i of Lᵀ·jumps, in the last rows of L. */
function jumpForce({ factor, nodes, jumps: { length } }: LastPart, jumps: readonly number[], i: number): number {
  const first = nodes.length;
  const size = first + length;
  let sum = 0;
  for (let k = i; k < length; k++) sum += factor[size * (first + k) + first + i] * jumps[k];
  return sum;
}
