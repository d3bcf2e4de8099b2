import { applySystem, type LastLevel, type PhaseSystem, type PhaseVector } from './PhaseSystem.js';

/** More unknowns than these are not worth a dense matrix: it would take longer than all else. */
const MOST_UNKNOWNS = 600;

/** A pivot below this share of its diagonal belongs to an unknown that nothing holds. */
const SMALLEST_PIVOT = 1e-9;

/** Factorises the last level, or returns null if it is too large. */
export function* factoriseLastLevel(system: PhaseSystem): Generator<number, LastLevel | null, void> {
  const nodeCount = system.levels[system.level].fans.length;
  const size = nodeCount + system.relations.jumps.free.length;
  if (size > MOST_UNKNOWNS) return null;
  const unit: PhaseVector = { nodes: new Float64Array(2 * nodeCount), jumps: new Float64Array(2 * (size - nodeCount)) };
  const column: PhaseVector = { nodes: unit.nodes.slice(), jumps: unit.jumps.slice() };
  const last = { size, nodeCount, factor: new Float64Array(size * size), inverses: new Float64Array(size) };
  for (let i = 0; i < size; i++) {
    const [part, k] = i < nodeCount ? [unit.nodes, i] : [unit.jumps, i - nodeCount];
    part[2 * k] = 1;
    yield* applySystem(system, unit, column);
    part[2 * k] = 0;
    for (let j = 0; j <= i; j++) {
      last.factor[size * i + j] = j < nodeCount ? column.nodes[2 * j] : column.jumps[2 * (j - nodeCount)];
    }
    factoriseRow(last, i);
  }
  return last;
}

/** Writes row i of the factor over that of the matrix. */
function factoriseRow({ size, factor, inverses }: LastLevel, i: number): void {
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

/** Solves for both families: for nodes and jumps, or for nodes alone where jumps are given. */
export function solveLastLevel(last: LastLevel, forces: PhaseVector, values: PhaseVector): void {
  const { size, nodeCount, factor, inverses } = last;
  const count = nodeCount + forces.jumps.length / 2;
  const x = new Float64Array(count);
  for (let family = 0; family < 2; family++) {
    for (let i = 0; i < count; i++) {
      let sum = i < nodeCount ? forces.nodes[2 * i + family] : forces.jumps[2 * (i - nodeCount) + family];
      for (let k = 0; k < i; k++) sum -= factor[size * i + k] * x[k];
      x[i] = sum * inverses[i];
    }
    for (let i = count - 1; i >= 0; i--) {
      x[i] *= inverses[i];
      for (let k = 0; k < i; k++) x[k] -= factor[size * i + k] * x[i];
    }
    for (let i = 0; i < count; i++) {
      if (i < nodeCount) values.nodes[2 * i + family] = x[i];
      else values.jumps[2 * (i - nodeCount) + family] = x[i];
    }
  }
}
