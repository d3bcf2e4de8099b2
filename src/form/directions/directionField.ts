import { asPhase } from '../../slices/asPhase.js';
import { forEachChunk } from '../../slices/forEachChunk.js';
import { type Cells, clusterNodes, coarsen } from '../cells.js';
import type { FormOptions } from '../FormOptions.js';
import type { FormSurface } from '../FormSurface.js';
import { assembleConnection, type Connection, cellTransports, coarseConnection } from './connection.js';
import { curvatureLines, type LineTargets } from './curvatureLines.js';
import { type Precision, solveConnection } from './solveConnection.js';
import { tangentFrames } from './tangentFrames.js';

/** A field of lines on the fans of a surface. */
export interface DirectionField {
  /** Two floats per fan: r·e^(2iθ), θ the angle of the line in the fan's frame, r how decided it is. */
  lines: Float64Array<ArrayBuffer>;
  /** See `tangentFrames`. */
  frames: Float32Array<ArrayBuffer>;
  /** See `LineTargets`. */
  anisotropy: Float32Array<ArrayBuffer>;
}

/** How many cells the surface is divided into, about, before the field is computed on its fans. */
const CELLS = 5000;

/** On cells the field is computed to the end; on fans it only has to become smooth. */
const ON_CELLS: Precision = { tolerance: 1e-4, passes: 1500 };
const ON_FANS: Precision = { tolerance: 1e-2, passes: 40 };

/** How far directions reach where it is decided which of the two principal directions lines take, as a share of the bounding radius. */
const FAR_REACH = 0.5;

/** Fans of a higher anisotropy always keep the most convex direction. */
const LARGEST_TURNED_ANISOTROPY = 4;

/**
 * Computes the field of lines along the form: the smoothest one that keeps to curvature where curvature says something. Which of
 * the two principal directions lines take is decided at large, so that they do not change from rings to meridians where a body
 * of revolution bends more along than around.
 */
export function* directionField(surface: FormSurface, options: FormOptions): Generator<number, DirectionField, void> {
  const frames = yield* asPhase(tangentFrames(surface.normals), 0, 0.03);
  const targets = yield* asPhase(curvatureLines(surface, frames, options), 0.03, 0.1);
  const connection = yield* asPhase(assembleConnection(surface.heat, surface.normals, frames), 0.1, 0.2);
  const lines = yield* asPhase(solveAtLarge(connection, targets, options.reach), 0.2, 0.5);
  yield* asPhase(solveConnection(connection, targets.weights, targets.right, lines, ON_FANS), 0.5, 1);
  return { lines, frames, anisotropy: targets.anisotropy };
}

/**
 * Computes the field on cells, carried to the fans. Turns those of the targets by 90° that are opposed to the field of far reach,
 * in place.
 */
function* solveAtLarge(
  connection: Connection,
  targets: LineTargets,
  reach: number,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const rings = Math.max(1, Math.round(Math.sqrt(targets.weights.length / CELLS / 2)));
  const cells = yield* asPhase(clusterNodes(connection, rings), 0, 0.2);
  const carried = yield* asPhase(cellTransports(connection, cells), 0.2, 0.25);
  const graph = yield* asPhase(coarsen(connection, cells), 0.25, 0.35);
  const coarse = yield* asPhase(coarseConnection(connection, carried, cells, graph), 0.35, 0.4);
  const ofCells = yield* asPhase(gatherTargets(targets, cells, carried), 0.4, 0.45);
  const lines = new Float64Array(2 * cells.count);
  const spread = new Float64Array(carried.length);
  const share = (reach / FAR_REACH) ** 2;
  const far = {
    weights: ofCells.weights.map((weight) => share * weight),
    right: ofCells.right.map((value) => share * value),
  };
  yield* asPhase(solveConnection(coarse, far.weights, far.right, lines, ON_CELLS), 0.45, 0.7);
  yield* asPhase(spreadLines(lines, cells, carried, spread), 0.7, 0.72);
  yield* asPhase(
    forEachChunk(targets.weights.length, (start, end) => turnOpposed(targets, spread, start, end)),
    0.72,
    0.75,
  );
  const { right } = yield* asPhase(gatherTargets(targets, cells, carried), 0.75, 0.78);
  yield* asPhase(solveConnection(coarse, ofCells.weights, right, lines, ON_CELLS), 0.78, 0.98);
  yield* asPhase(spreadLines(lines, cells, carried, spread), 0.98, 1);
  return spread;
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
  lines: Float64Array,
): Generator<number, void, void> {
  yield* forEachChunk(ofNode.length, (start, end) => spreadRange(ofCells, ofNode, carried, lines, start, end));
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
