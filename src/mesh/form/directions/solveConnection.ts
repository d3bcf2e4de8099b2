import { forEachChunk } from '../../phases.js';
import type { Connection } from './connection.js';

/** Stopping criteria of conjugate gradients. */
export interface Precision {
  /** The share of the right side that may remain as residual. */
  tolerance: number;
  /** The largest number of iterations. */
  passes: number;
}

/** State of conjugate gradients: complex numbers, two floats per node. */
interface Search {
  /** For each node the sum of its degree and its weight; one float. */
  diagonal: Float64Array;
  residuals: Float64Array;
  directions: Float64Array;
  /** The matrix times `directions`. */
  products: Float64Array;
}

/**
 * Solves (L + W)·lines = right in place, by conjugate gradients preconditioned with the diagonal. L is the connection Laplacian,
 * W a diagonal matrix. It starts from the lines that it is given.
 *
 * @param weights the diagonal of W, one per node
 * @param right two floats per node
 * @param lines two floats per node
 * @returns the number of passes
 */
export function* solveConnection(
  connection: Connection,
  weights: Float64Array,
  right: Float64Array,
  lines: Float64Array,
  { tolerance, passes }: Precision,
): Generator<number, number, void> {
  const count = weights.length;
  const diagonal = new Float64Array(count);
  for (let node = 0; node < count; node++) diagonal[node] = connection.degrees[node] + weights[node] || 1;
  const search = {
    diagonal,
    residuals: right.slice(),
    directions: lines.slice(),
    products: new Float64Array(2 * count),
  };
  const target = tolerance ** 2 * squareRange(search, 0, count);
  yield* multiply(connection, search);
  for (let i = 0; i < right.length; i++) search.residuals[i] -= search.products[i];
  let square = squareRange(search, 0, count);
  turnRange(search, 0, 0, count);
  for (let pass = 0; pass < passes; pass++) {
    if (!(square > target)) return pass;
    const step = square / (yield* multiply(connection, search));
    const before = square;
    square = 0;
    yield* forEachChunk(count, (start, end) => {
      square += stepRange(search, lines, step, start, end);
    });
    yield* forEachChunk(count, (start, end) => turnRange(search, square / before, start, end));
  }
  return passes;
}

/** Multiplies the directions by the matrix. Returns their scalar product with the products. */
function* multiply(connection: Connection, search: Search): Generator<number, number, void> {
  let product = 0;
  yield* forEachChunk(search.diagonal.length, (start, end) => {
    product += multiplyRange(connection, search, start, end);
  });
  return product;
}

function multiplyRange(
  { starts, neighbours, transports }: Connection,
  { diagonal, directions, products }: Search,
  start: number,
  end: number,
): number {
  let product = 0;
  let entry = starts[start];
  for (let node = start; node < end; node++) {
    const ownX = directions[2 * node];
    const ownY = directions[2 * node + 1];
    let x = diagonal[node] * ownX;
    let y = diagonal[node] * ownY;
    for (const last = starts[node + 1]; entry < last; entry++) {
      const other = 2 * neighbours[entry];
      const otherX = directions[other];
      const otherY = directions[other + 1];
      const tx = transports[2 * entry];
      const ty = transports[2 * entry + 1];
      x -= tx * otherX - ty * otherY;
      y -= tx * otherY + ty * otherX;
    }
    products[2 * node] = x;
    products[2 * node + 1] = y;
    product += x * ownX + y * ownY;
  }
  return product;
}

/** Moves lines and residuals along the direction. Returns the square of the residuals. */
function stepRange(search: Search, lines: Float64Array, step: number, start: number, end: number): number {
  const { residuals, directions, products } = search;
  for (let i = 2 * start; i < 2 * end; i++) {
    lines[i] += step * directions[i];
    residuals[i] -= step * products[i];
  }
  return squareRange(search, start, end);
}

/** The square of the residuals in the norm of the preconditioner. */
function squareRange({ diagonal, residuals }: Search, start: number, end: number): number {
  let square = 0;
  for (let node = start; node < end; node++) {
    const x = residuals[2 * node];
    const y = residuals[2 * node + 1];
    square += (x * x + y * y) / diagonal[node];
  }
  return square;
}

/** The next direction: the preconditioned residual plus a share of the previous direction. */
function turnRange({ diagonal, residuals, directions }: Search, share: number, start: number, end: number): void {
  for (let node = start; node < end; node++) {
    const inverse = 1 / diagonal[node];
    directions[2 * node] = inverse * residuals[2 * node] + share * directions[2 * node];
    directions[2 * node + 1] = inverse * residuals[2 * node + 1] + share * directions[2 * node + 1];
  }
}
