import { disjointSets, join, rootOf } from '../../disjointSets.js';
import { applySystem, type LastPart, type PhaseSystem, type PhaseVector } from './PhaseSystem.js';

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
