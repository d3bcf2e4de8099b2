import { forEachChunk } from '../../phases.js';
import { applySystem, gatherJumps, type PhaseSystem, type PhaseVector } from './PhaseSystem.js';
import { precondition } from './precondition.js';

/** Stopping criteria of a solver. */
export interface Patience {
  /** The residual at the end relative to that at the start, in the norm of the preconditioner. */
  tolerance: number;
  /** The largest number of steps. */
  steps: number;
}

/**
 * Solves a system by conjugate gradients, preconditioned by a V-cycle. The two families of lines have step lengths of their own and stop
 * independently: neither changes a bit of the other.
 *
 * @param forces the right side
 * @param x the unknowns: a first guess, then the solution
 * @returns the number of steps taken
 */
export function* conjugateGradients(
  system: PhaseSystem,
  forces: PhaseVector,
  x: PhaseVector,
  { tolerance, steps }: Patience,
): Generator<number, number, void> {
  const { forces: r, values: z, rest: q } = system.buffers[system.level];
  const p: PhaseVector = { nodes: new Float64Array(x.nodes.length), jumps: new Float64Array(x.jumps.length) };
  const families: Family[] = [newFamily(), newFamily()];
  yield* applySystem(system, x, q);
  yield* overBoth(system, x, (k, start, end) => subtractRange(forces[k], q[k], r[k], start, end));
  for (let step = 0; ; step++) {
    yield* precondition(system);
    yield* dot(system, r, z, families);
    for (const family of families) turn(family, step, tolerance);
    if (step === steps || families.every(({ isDone }) => isDone)) return step;
    const [{ beta }, { beta: beta2 }] = families;
    yield* overBoth(system, x, (k, start, end) => turnRange(p[k], z[k], beta, beta2, start, end));
    yield* applySystem(system, p, q);
    yield* dot(system, p, q, families);
    const [alpha, alpha2] = families.map(({ isDone, length, product }) =>
      isDone || product <= 0 ? 0 : length / product,
    );
    yield* overBoth(system, x, (k, start, end) => stepRange(x[k], r[k], p[k], q[k], alpha, alpha2, start, end));
  }
}

/** State of conjugate gradients for one family of lines. */
interface Family {
  /** The scalar product that was computed last. */
  product: number;
  /** The squared length of the residual, now and at the beginning. */
  length: number;
  firstLength: number;
  /** The share of the previous direction in the next one. */
  beta: number;
  isDone: boolean;
}

const newFamily = (): Family => ({ product: 0, length: 0, firstLength: 0, beta: 0, isDone: false });

/** Takes the scalar product of the residual with itself, from which the next direction follows, unless the residual is short enough. */
function turn(family: Family, step: number, tolerance: number): void {
  const { product } = family;
  if (step === 0) family.firstLength = product;
  family.isDone ||= !(product > tolerance * tolerance * family.firstLength);
  family.beta = step === 0 || family.isDone ? 0 : product / family.length;
  family.length = product;
}

/** Runs `body` over the pairs of both parts of a vector, or of the nodes alone where jumps are given. */
function* overBoth(
  { isFree }: PhaseSystem,
  { nodes, jumps }: PhaseVector,
  body: (part: 'nodes' | 'jumps', start: number, end: number) => void,
): Generator<number, void, void> {
  yield* forEachChunk(nodes.length / 2, (start, end) => body('nodes', start, end));
  if (isFree) body('jumps', 0, jumps.length / 2);
}

function* dot(
  system: PhaseSystem,
  a: PhaseVector,
  b: PhaseVector,
  families: readonly Family[],
): Generator<number, void, void> {
  for (const family of families) family.product = 0;
  yield* overBoth(system, a, (part, start, end) => dotRange(a[part], b[part], families, start, end));
}

function dotRange(a: Float64Array, b: Float64Array, families: readonly Family[], start: number, end: number): void {
  let sum = 0;
  let sum2 = 0;
  for (let i = 2 * start; i < 2 * end; i += 2) {
    sum += a[i] * b[i];
    sum2 += a[i + 1] * b[i + 1];
  }
  families[0].product += sum;
  families[1].product += sum2;
}

/** difference ← a − b. */
function subtractRange(a: Float64Array, b: Float64Array, difference: Float64Array, start: number, end: number): void {
  for (let i = 2 * start; i < 2 * end; i++) difference[i] = a[i] - b[i];
}

/** p ← z + β·p. */
function turnRange(p: Float64Array, z: Float64Array, beta: number, beta2: number, start: number, end: number): void {
  for (let i = 2 * start; i < 2 * end; i += 2) {
    p[i] = z[i] + beta * p[i];
    p[i + 1] = z[i + 1] + beta2 * p[i + 1];
  }
}

/** x ← x + α·p, r ← r − α·q. */
function stepRange(
  x: Float64Array,
  r: Float64Array,
  p: Float64Array,
  q: Float64Array,
  alpha: number,
  alpha2: number,
  start: number,
  end: number,
): void {
  for (let i = 2 * start; i < 2 * end; i += 2) {
    x[i] += alpha * p[i];
    x[i + 1] += alpha2 * p[i + 1];
    r[i] -= alpha * q[i];
    r[i + 1] -= alpha2 * q[i + 1];
  }
}

/** The right side of a level: forces on the nodes and the offsets. */
export interface FreeForces {
  nodes: Float64Array;
  offsets: Float64Array;
}

/** Solves for nodes and jumps, except for fixed jumps. */
export function* solveFree(
  system: PhaseSystem,
  forces: FreeForces,
  x: PhaseVector,
  patience: Patience,
): Generator<number, void, void> {
  const jumps = new Float64Array(x.jumps.length);
  system.seamBuffers.pulls.set(forces.offsets);
  gatherJumps(system, jumps);
  yield* conjugateGradients(system, { nodes: forces.nodes, jumps }, x, patience);
}
