import { forEachChunk } from '../../phases.js';
import type { PhaseMatrix, SeamEdges } from './phaseMatrix.js';

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
