import { forEachChunk } from '../../phases.js';
import type { PhaseLevel } from './phaseLevels.js';
import type { PhaseMatrix, SeamEdges } from './phaseMatrix.js';
import { jumpPulls, offsetsOf, type SeamRelations } from './seamRelations.js';

/** The unknowns of both families of lines, or the forces on them: two values for each node and for each free jump. */
export interface PhaseVector {
  nodes: Float64Array;
  jumps: Float64Array;
}

/** The equations of φ, and the scratch memory of their solvers. */
export interface PhaseSystem {
  levels: readonly PhaseLevel[];
  buffers: readonly LevelBuffers[];
  relations: SeamRelations;
  seamBuffers: SeamBuffers;
  /** For each free jump the bound of its diagonal entry. */
  jumpDiagonal: Float64Array;
  /** Parts of the last level that a direct solver takes. */
  lastParts: readonly LastPart[];
  /** The level whose equations are solved. */
  level: number;
  /** Whether jumps are unknowns too, instead of given. */
  isFree: boolean;
  /** For each value of a free jump, two for each, 1 if it is fixed; null while none is. Once some are, `lastParts` are fixed entirely. */
  held: Uint8Array | null;
}

/**
 * A part of the last level whose unknowns depend on no others, such as a part of an assembly. Its matrix is L·Lᵀ, by Cholesky; nodes come
 * before jumps, so that the first rows of L are the factor for given jumps.
 */
export interface LastPart {
  /** The numbers of its nodes and free jumps. */
  nodes: readonly number[];
  jumps: readonly number[];
  /** L, row by row. */
  factor: Float64Array;
  /** For each unknown 1 over its diagonal in L, or 0 for an undetermined unknown, which stays 0. */
  inverses: Float64Array;
}

/** Vectors of one level. */
interface LevelBuffers {
  forces: PhaseVector;
  values: PhaseVector;
  rest: PhaseVector;
}

/** Vectors of the cut, two values each. */
interface SeamBuffers {
  segments: Float64Array;
  offsets: Float64Array;
  pulls: Float64Array;
}

/** The system without parts of the last level. */
export function phaseSystem(relations: SeamRelations, levels: readonly PhaseLevel[]): PhaseSystem {
  const { segmentCount, origins, jumps } = relations;
  const vectorOf = ({ fans }: PhaseLevel): PhaseVector => ({
    nodes: new Float64Array(2 * fans.length),
    jumps: new Float64Array(2 * jumps.free.length),
  });
  return {
    levels,
    buffers: levels.map((level) => ({ forces: vectorOf(level), values: vectorOf(level), rest: vectorOf(level) })),
    relations,
    seamBuffers: {
      segments: new Float64Array(2 * segmentCount),
      offsets: new Float64Array(2 * origins.length),
      pulls: new Float64Array(2 * origins.length),
    },
    jumpDiagonal: jumpDiagonal(relations, levels[0].matrix.seam),
    lastParts: [],
    level: levels.length - 1,
    isFree: true,
    held: null,
  };
}

/** Multiplies the matrix of the system with a vector. */
export function* applySystem(
  system: PhaseSystem,
  { nodes, jumps }: PhaseVector,
  product: PhaseVector,
): Generator<number, void, void> {
  const { matrix } = system.levels[system.level];
  yield* multiply(matrix, nodes, product.nodes);
  if (!system.isFree) return;
  const { offsets, pulls } = system.seamBuffers;
  spreadJumps(system, jumps);
  pullNodes(matrix.seam, offsets, 1, product.nodes);
  pullOffsets(matrix.seam, nodes, offsets, pulls);
  gatherJumps(system, product.jumps);
}

/** Writes the offsets that follow from the free jumps. */
export function spreadJumps({ relations, seamBuffers: { segments, offsets } }: PhaseSystem, jumps: Float64Array): void {
  const { free } = relations.jumps;
  for (let i = 0; i < free.length; i++) {
    segments[2 * free[i]] = jumps[2 * i];
    segments[2 * free[i] + 1] = jumps[2 * i + 1];
  }
  offsetsOf(relations, segments, offsets);
}

/** Adds up the forces on the offsets to forces on the free jumps; zero where they are fixed. Overwrites the forces on the offsets. */
export function gatherJumps(
  { relations, seamBuffers: { segments, pulls }, held }: PhaseSystem,
  jumps: Float64Array,
): void {
  const { free } = relations.jumps;
  jumpPulls(relations, pulls, segments);
  for (let i = 0; i < free.length; i++) {
    jumps[2 * i] = segments[2 * free[i]];
    jumps[2 * i + 1] = segments[2 * free[i] + 1];
  }
  if (held) for (let i = 0; i < held.length; i++) if (held[i] === 1) jumps[i] = 0;
}

/** Sums up, for each free jump, the weights of all edges that it moves: a bound on how strongly it is held. */
function jumpDiagonal(relations: SeamRelations, seam: SeamEdges): Float64Array {
  const { origins, starts, segments, factors, jumps } = relations;
  const weights = new Float64Array(origins.length);
  for (let end = 0; end < seam.offsets.length; end++) {
    if (seam.offsets[end] >= 0) weights[seam.offsets[end]] += Math.abs(seam.weights[end >> 1]);
  }
  const ofSegment = new Float64Array(relations.segmentCount);
  for (let i = origins.length - 1; i >= 0; i--) {
    if (origins[i] >= 0) weights[origins[i]] += weights[i];
    for (let term = starts[i]; term < starts[i + 1]; term++) {
      ofSegment[segments[term]] += Math.abs(factors[term]) * weights[i];
    }
  }
  for (let i = jumps.bound.length - 1; i >= 0; i--) {
    for (let term = jumps.starts[i]; term < jumps.starts[i + 1]; term++) {
      ofSegment[jumps.segments[term]] += Math.abs(jumps.factors[term]) * ofSegment[jumps.bound[i]];
    }
  }
  return Float64Array.from(jumps.free, (segment) => ofSegment[segment] || 1);
}

/** Multiplies the matrix with a vector. Vectors have two values per node, one per family of lines, side by side. */
export function* multiply(matrix: PhaseMatrix, x: Float64Array, product: Float64Array): Generator<number, void, void> {
  yield* forEachChunk(matrix.diagonal.length, (start, end) => multiplyRange(matrix, x, product, start, end));
}

function multiplyRange(
  { starts, neighbours, values, diagonal }: PhaseMatrix,
  x: Float64Array,
  product: Float64Array,
  start: number,
  end: number,
): void {
  let entry = starts[start];
  for (let node = start; node < end; node++) {
    let sum = diagonal[node] * x[2 * node];
    let sum2 = diagonal[node] * x[2 * node + 1];
    for (const last = starts[node + 1]; entry < last; entry++) {
      const other = 2 * neighbours[entry];
      const value = values[entry];
      sum += value * x[other];
      sum2 += value * x[other + 1];
    }
    product[2 * node] = sum;
    product[2 * node + 1] = sum2;
  }
}

/** Writes forces − matrix · x. */
export function* residual(
  matrix: PhaseMatrix,
  forces: Float64Array,
  x: Float64Array,
  rest: Float64Array,
): Generator<number, void, void> {
  yield* forEachChunk(matrix.diagonal.length, (start, end) => {
    multiplyRange(matrix, x, rest, start, end);
    subtractRange(forces, rest, 2 * start, 2 * end);
  });
}

function subtractRange(forces: Float64Array, rest: Float64Array, start: number, end: number): void {
  for (let i = start; i < end; i++) rest[i] = forces[i] - rest[i];
}

/** One Gauss-Seidel sweep through all nodes, forwards or backwards. */
export function* sweep(
  matrix: PhaseMatrix,
  forces: Float64Array,
  x: Float64Array,
  direction: 1 | -1,
): Generator<number, void, void> {
  const count = matrix.diagonal.length;
  yield* forEachChunk(count, (start, end) => {
    if (direction === 1) sweepRange(matrix, forces, x, start, end, 1);
    else sweepRange(matrix, forces, x, count - 1 - start, count - 1 - end, -1);
  });
}

function sweepRange(
  { starts, neighbours, values, diagonal }: PhaseMatrix,
  forces: Float64Array,
  x: Float64Array,
  first: number,
  end: number,
  direction: 1 | -1,
): void {
  for (let node = first; node !== end; node += direction) {
    let sum = forces[2 * node];
    let sum2 = forces[2 * node + 1];
    for (let entry = starts[node], last = starts[node + 1]; entry < last; entry++) {
      const other = 2 * neighbours[entry];
      const value = values[entry];
      sum -= value * x[other];
      sum2 -= value * x[other + 1];
    }
    x[2 * node] = sum / diagonal[node];
    x[2 * node + 1] = sum2 / diagonal[node];
  }
}

/** Adds `factor` times the product of the offsets with the matrix block that couples them to the nodes. */
export function pullNodes(seam: SeamEdges, offsets: Float64Array, factor: 1 | -1, product: Float64Array): void {
  const { nodes, signs, offsets: ofEnd, weights } = seam;
  for (let edge = 0; edge < weights.length; edge++) {
    const a = 2 * ofEnd[2 * edge];
    const b = 2 * ofEnd[2 * edge + 1];
    const weight = factor * weights[edge];
    const rise = weight * ((a < 0 ? 0 : offsets[a]) - (b < 0 ? 0 : offsets[b]));
    const rise2 = weight * ((a < 0 ? 0 : offsets[a + 1]) - (b < 0 ? 0 : offsets[b + 1]));
    const p = 2 * nodes[2 * edge];
    const q = 2 * nodes[2 * edge + 1];
    product[p] += signs[2 * edge] * rise;
    product[p + 1] += signs[2 * edge] * rise2;
    product[q] -= signs[2 * edge + 1] * rise;
    product[q + 1] -= signs[2 * edge + 1] * rise2;
  }
}

/** Writes the forces of nodes and offsets on the offsets. */
export function pullOffsets(seam: SeamEdges, x: Float64Array, offsets: Float64Array, pulls: Float64Array): void {
  const { nodes, signs, offsets: ofEnd, weights } = seam;
  pulls.fill(0);
  for (let edge = 0; edge < weights.length; edge++) {
    const a = 2 * ofEnd[2 * edge];
    const b = 2 * ofEnd[2 * edge + 1];
    const p = 2 * nodes[2 * edge];
    const q = 2 * nodes[2 * edge + 1];
    const sign = signs[2 * edge];
    const sign2 = signs[2 * edge + 1];
    const weight = weights[edge];
    const rise = sign * x[p] - sign2 * x[q] + (a < 0 ? 0 : offsets[a]) - (b < 0 ? 0 : offsets[b]);
    const rise2 = sign * x[p + 1] - sign2 * x[q + 1] + (a < 0 ? 0 : offsets[a + 1]) - (b < 0 ? 0 : offsets[b + 1]);
    if (a >= 0) {
      pulls[a] += weight * rise;
      pulls[a + 1] += weight * rise2;
    }
    if (b >= 0) {
      pulls[b] -= weight * rise;
      pulls[b + 1] -= weight * rise2;
    }
  }
}
