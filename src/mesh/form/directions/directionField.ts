import { type Cells, type CoarseGraph, clusterNodes, coarsen } from '../../adjacency/cells.js';
import { asPhase, forEachChunk, release } from '../../phases.js';
import type { FormOptions } from '../FormField.js';
import type { FormSurface } from '../FormSurface.js';
import { bendSigns } from './bendSigns.js';
import {
  assembleConnection,
  type Connection,
  cellTransports,
  coarseConnection,
  tangentFrames,
  weighConnection,
} from './connection.js';
import { curvatureLines, type LineTargets, prominence, weighTargets } from './curvatureLines.js';
import { type Precision, solveConnection } from './solveConnection.js';

/** A field of lines on the fans of a surface. */
export interface DirectionField {
  /** Two floats per fan: r·e^(2iθ), where θ is the angle of the line in the fan's frame and r its certainty. */
  lines: Float64Array<ArrayBuffer>;
  /** See `tangentFrames`. */
  frames: Float32Array<ArrayBuffer>;
  /** See `LineTargets`. */
  anisotropy: Float32Array<ArrayBuffer>;
}

/** Approximate number of cells on which the field is computed before the fans. */
const CELLS = 5000;

/** On cells the field converges; on fans it only has to become smooth. */
const ON_CELLS: Precision = { tolerance: 1e-4, passes: 1500 };
const ON_FANS: Precision = { tolerance: 1e-2, passes: 40 };

/** Reach of the field that decides which of the two principal directions lines take, as a share of the bounding radius. */
const FAR_REACH = 0.5;

/** Fans of a higher anisotropy always keep the most convex direction. */
const LARGEST_TURNED_ANISOTROPY = 4;

/** Number of times the field of far reach is solved and the targets opposed to it are turned. Each round makes the targets clearer. */
const ROUNDS = 2;

/**
 * Computes the field of lines along the form: the smoothest one that keeps to curvature where that is decided. Which of the two principal
 * directions lines take is decided at large scale, so that they do not change from rings to meridians where a body of revolution bends more
 * along than around. Then weights are multiplied by prominence.
 *
 * @param surface its tensors are freed, and the weights of its heat equation
 */
export function* directionField(surface: FormSurface, options: FormOptions): Generator<number, DirectionField, void> {
  const frames = yield* asPhase(tangentFrames(surface.normals), 0, 0.03);
  const signs = yield* asPhase(bendSigns(surface), 0.03, 0.07);
  const targets = yield* asPhase(curvatureLines(surface, frames, signs, options), 0.07, 0.12);
  const connection = yield* asPhase(assembleConnection(surface.heat, surface.normals, frames), 0.12, 0.22);
  release(surface.tensors, surface.heat.weights);
  const division = yield* asPhase(divideIntoCells(connection), 0.22, 0.3);
  yield* asPhase(turnAtLarge(connection, division, targets, options.reach), 0.3, 0.42);
  const prominences = yield* asPhase(prominence(surface, signs, options), 0.42, 0.44);
  yield* asPhase(weighConnection(connection, prominences), 0.44, 0.47);
  yield* asPhase(weighTargets(targets, prominences), 0.47, 0.48);
  const lines = yield* asPhase(solveOnCells(connection, division, targets), 0.48, 0.6);
  yield* asPhase(solveConnection(connection, targets.weights, targets.right, lines, ON_FANS), 0.6, 1);
  return { lines, frames, anisotropy: targets.anisotropy };
}

/** The division of the surface into cells, on which the field is computed first. */
interface Division {
  cells: Cells;
  graph: CoarseGraph;
  /** See `cellTransports`. */
  carried: Float64Array;
}

function* divideIntoCells(connection: Connection): Generator<number, Division, void> {
  const fanCount = connection.degrees.length;
  const rings = Math.max(1, Math.round(Math.sqrt(fanCount / CELLS / 2)));
  const cells = yield* asPhase(clusterNodes(connection, rings), 0, 0.5);
  const carried = yield* asPhase(cellTransports(connection, cells), 0.5, 0.7);
  const graph = yield* asPhase(coarsen(connection, cells), 0.7, 1);
  return { cells, graph, carried };
}

/** Turns by 90°, in place, the targets that are opposed to the field of far reach. */
function* turnAtLarge(
  connection: Connection,
  { cells, graph, carried }: Division,
  targets: LineTargets,
  reach: number,
): Generator<number, void, void> {
  const coarse = yield* asPhase(coarseConnection(connection, carried, cells, graph), 0, 0.1);
  const lines = new Float64Array(2 * cells.count);
  const share = (reach / FAR_REACH) ** 2;
  for (let round = 0; round < ROUNDS; round++) {
    const { weights, right } = yield* gatherTargets(targets, cells, carried);
    for (let i = 0; i < right.length; i++) right[i] *= share;
    for (let cell = 0; cell < cells.count; cell++) weights[cell] *= share;
    yield* asPhase(solveConnection(coarse, weights, right, lines, ON_CELLS), round / ROUNDS, (round + 0.9) / ROUNDS);
    const spread = yield* spreadLines(lines, cells, carried);
    yield* forEachChunk(targets.weights.length, (start, end) => turnOpposed(targets, spread, start, end));
  }
}

/** Computes the field on cells, and carries it to the fans. */
function* solveOnCells(
  connection: Connection,
  { cells, graph, carried }: Division,
  targets: LineTargets,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const coarse = yield* asPhase(coarseConnection(connection, carried, cells, graph), 0, 0.2);
  const { weights, right } = yield* asPhase(gatherTargets(targets, cells, carried), 0.2, 0.3);
  const lines = new Float64Array(2 * cells.count);
  yield* asPhase(solveConnection(coarse, weights, right, lines, ON_CELLS), 0.3, 0.9);
  return yield* asPhase(spreadLines(lines, cells, carried), 0.9, 1);
}

/** Sums the targets of fans over cells, each carried back to the seed. */
function* gatherTargets(
  { weights, right }: LineTargets,
  { ofNode, count }: Cells,
  carried: Float64Array,
): Generator<number, Pick<LineTargets, 'weights' | 'right'>, void> {
  const sums = { weights: new Float64Array(count), right: new Float64Array(2 * count) };
  yield* forEachChunk(weights.length, (start, end) => gatherRange(weights, right, ofNode, carried, sums, start, end));
  return sums;
}

function gatherRange(
  weights: Float64Array,
  right: Float64Array,
  ofNode: Uint32Array,
  carried: Float64Array,
  sums: Pick<LineTargets, 'weights' | 'right'>,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const cell = ofNode[fan];
    const x = carried[2 * fan];
    const y = carried[2 * fan + 1];
    sums.weights[cell] += weights[fan];
    sums.right[2 * cell] += x * right[2 * fan] + y * right[2 * fan + 1];
    sums.right[2 * cell + 1] += x * right[2 * fan + 1] - y * right[2 * fan];
  }
}

/** Gives each fan the line of its cell. */
function* spreadLines(
  ofCells: Float64Array,
  { ofNode }: Cells,
  carried: Float64Array,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const lines = new Float64Array(carried.length);
  yield* forEachChunk(ofNode.length, (start, end) => spreadRange(ofCells, ofNode, carried, lines, start, end));
  return lines;
}

function spreadRange(
  ofCells: Float64Array,
  ofNode: Uint32Array,
  carried: Float64Array,
  lines: Float64Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const x = ofCells[2 * ofNode[fan]];
    const y = ofCells[2 * ofNode[fan] + 1];
    lines[2 * fan] = carried[2 * fan] * x - carried[2 * fan + 1] * y;
    lines[2 * fan + 1] = carried[2 * fan] * y + carried[2 * fan + 1] * x;
  }
}

/** Lines turned by 90° have the opposite complex number. */
function turnOpposed(
  { right, curved, anisotropy }: LineTargets,
  lines: Float64Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const x = curved[2 * fan];
    const y = curved[2 * fan + 1];
    if (anisotropy[fan] >= LARGEST_TURNED_ANISOTROPY || lines[2 * fan] * x + lines[2 * fan + 1] * y >= 0) continue;
    right[2 * fan] -= 2 * x;
    right[2 * fan + 1] -= 2 * y;
  }
}
