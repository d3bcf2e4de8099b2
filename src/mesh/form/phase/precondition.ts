import type { Cells } from '../../adjacency/cells.js';
import { disjointSets, join, rootOf } from '../../disjointSets.js';
import { forEachChunk } from '../../phases.js';
import {
  applySystem,
  gatherJumps,
  type LastPart,
  type PhaseSystem,
  type PhaseVector,
  pullNodes,
  pullOffsets,
  residual,
  spreadJumps,
  sweep,
} from './PhaseSystem.js';

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

/** Largest number of unknowns of a part that is solved directly: a larger dense matrix would take longer than all else. */
const MOST_UNKNOWNS = 600;

/** A pivot below this share of its diagonal belongs to an undetermined unknown. */
const SMALLEST_PIVOT = 1e-9;

/** Factorises the parts of the last level, except for those that are too large. */
export function* factoriseLastLevel(system: PhaseSystem): Generator<number, LastPart[], void> {
  const parts = partsOf(system).filter((part) => sizeOf(part) <= MOST_UNKNOWNS);
  const unit: PhaseVector = {
    nodes: new Float64Array(2 * system.levels[system.level].fans.length),
    jumps: new Float64Array(2 * system.relations.jumps.free.length),
  };
  const column: PhaseVector = { nodes: unit.nodes.slice(), jumps: unit.jumps.slice() };
  const most = parts.reduce((size, part) => Math.max(size, sizeOf(part)), 0);
  // Parts are independent, so one product gives a column of each.
  for (let i = 0; i < most; i++) {
    const reached = parts.filter((part) => sizeOf(part) > i);
    for (const part of reached) setUnknown(part, unit, i, 1);
    yield* applySystem(system, unit, column);
    for (const part of reached) {
      setUnknown(part, unit, i, 0);
      for (let j = 0; j <= i; j++) part.factor[sizeOf(part) * i + j] = unknownOf(part, column, j);
      factoriseRow(part, i);
    }
  }
  return parts;
}

const sizeOf = ({ nodes, jumps }: LastPart): number => nodes.length + jumps.length;

/** Sets the unknown i of a part, for the first family. */
function setUnknown({ nodes, jumps }: LastPart, vector: PhaseVector, i: number, value: number): void {
  if (i < nodes.length) vector.nodes[2 * nodes[i]] = value;
  else vector.jumps[2 * jumps[i - nodes.length]] = value;
}

function unknownOf({ nodes, jumps }: LastPart, vector: PhaseVector, i: number): number {
  return i < nodes.length ? vector.nodes[2 * nodes[i]] : vector.jumps[2 * jumps[i - nodes.length]];
}

/** Finds the parts of more than one unknown. */
function partsOf({ levels, level, relations }: PhaseSystem): LastPart[] {
  const { matrix, fans } = levels[level];
  const { origins, starts, segments, segmentCount, jumps } = relations;
  // Nodes, then offsets, then segments.
  const offset = fans.length;
  const segment = offset + origins.length;
  const sets = disjointSets(segment + segmentCount);
  for (let node = 0; node < fans.length; node++) {
    for (let entry = matrix.starts[node]; entry < matrix.starts[node + 1]; entry++) {
      join(sets, node, matrix.neighbours[entry]);
    }
  }
  const { nodes, offsets } = matrix.seam;
  for (let end = 0; end < nodes.length; end++) if (offsets[end] >= 0) join(sets, nodes[end], offset + offsets[end]);
  for (let end = 0; end < nodes.length; end += 2) {
    if (offsets[end] >= 0) join(sets, nodes[end + 1], offset + offsets[end]);
    if (offsets[end + 1] >= 0) join(sets, nodes[end], offset + offsets[end + 1]);
  }
  for (let i = 0; i < origins.length; i++) {
    if (origins[i] >= 0) join(sets, offset + i, offset + origins[i]);
    for (let term = starts[i]; term < starts[i + 1]; term++) join(sets, offset + i, segment + segments[term]);
  }
  for (let i = 0; i < jumps.bound.length; i++) {
    for (let term = jumps.starts[i]; term < jumps.starts[i + 1]; term++) {
      join(sets, segment + jumps.bound[i], segment + jumps.segments[term]);
    }
  }
  const parts = new Map<number, { nodes: number[]; jumps: number[] }>();
  const partOf = (member: number) => {
    const root = rootOf(sets, member);
    const part = parts.get(root) ?? { nodes: [], jumps: [] };
    parts.set(root, part);
    return part;
  };
  for (let node = 0; node < fans.length; node++) partOf(node).nodes.push(node);
  for (const [i, free] of jumps.free.entries()) partOf(segment + free).jumps.push(i);
  return [...parts.values()].filter(({ nodes, jumps }) => nodes.length + jumps.length > 1).map(newPart);
}

function newPart({ nodes, jumps }: { nodes: number[]; jumps: number[] }): LastPart {
  const size = nodes.length + jumps.length;
  const kept = size <= MOST_UNKNOWNS ? size : 0;
  return { nodes, jumps, factor: new Float64Array(kept * kept), inverses: new Float64Array(kept) };
}

/** Writes row i of the factor over that of the matrix. */
function factoriseRow(part: LastPart, i: number): void {
  const { factor, inverses } = part;
  const size = sizeOf(part);
  const row = size * i;
  const diagonal = factor[row + i];
  let pivot = diagonal;
  for (let j = 0; j < i; j++) {
    let sum = factor[row + j];
    for (let k = 0; k < j; k++) sum -= factor[row + k] * factor[size * j + k];
    factor[row + j] = sum * inverses[j];
    pivot -= factor[row + j] * factor[row + j];
  }
  inverses[i] = pivot > SMALLEST_PIVOT * diagonal ? 1 / Math.sqrt(pivot) : 0;
}

/** Solves a part for both families: for nodes and jumps, or for nodes alone where jumps are given. */
export function solveLastPart(part: LastPart, forces: PhaseVector, values: PhaseVector, isFree: boolean): void {
  const { nodes, jumps, factor, inverses } = part;
  const size = sizeOf(part);
  const count = isFree ? size : nodes.length;
  const x = new Float64Array(count);
  for (let family = 0; family < 2; family++) {
    for (let i = 0; i < count; i++) {
      let sum =
        i < nodes.length ? forces.nodes[2 * nodes[i] + family] : forces.jumps[2 * jumps[i - nodes.length] + family];
      for (let k = 0; k < i; k++) sum -= factor[size * i + k] * x[k];
      x[i] = sum * inverses[i];
    }
    for (let i = count - 1; i >= 0; i--) {
      x[i] *= inverses[i];
      for (let k = 0; k < i; k++) x[k] -= factor[size * i + k] * x[i];
    }
    for (let i = 0; i < count; i++) {
      if (i < nodes.length) values.nodes[2 * nodes[i] + family] = x[i];
      else values.jumps[2 * jumps[i - nodes.length] + family] = x[i];
    }
  }
}
