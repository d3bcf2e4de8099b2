import type { Cells, CoarseGraph, Graph } from '../../adjacency/cells.js';
import type { HeatEquation } from '../../normals/assembleHeatEquation.js';
import { forEachChunk } from '../../phases.js';

/**
 * The connection Laplacian of line fields. A line at a fan is a complex number r·e^(2iθ), where θ is its angle in the fan's
 * frame: doubled, because a line has no sign. To be compared, lines are carried from fan to fan.
 */
export interface Connection extends Graph {
  /** Two floats per entry: the complex number that carries a line from the neighbour to the fan, times the weight of the edge. */
  transports: Float32Array;
  /** For each fan the sum of the weights of its edges. */
  degrees: Float64Array;
}

/** Least weight of an edge. Cotangents of obtuse angles are negative, which would make a field turn. */
const LEAST_WEIGHT = 0.02;

/** Bound on the denominator for opposite normals, between which no rotation is the shortest. */
const LEAST_ROTATION = 1e-3;

/** Assembles the connection Laplacian from the cotangents of the heat equation. A line is carried by the shortest rotation of its normal. */
export function* assembleConnection(
  heat: HeatEquation,
  normals: Float32Array,
  frames: Float32Array,
): Generator<number, Connection, void> {
  const fanCount = heat.masses.length;
  const connection: Connection = {
    starts: heat.starts,
    neighbours: heat.neighbours,
    transports: new Float32Array(2 * heat.neighbours.length),
    degrees: new Float64Array(fanCount),
  };
  yield* forEachChunk(fanCount, (start, end) => assembleRange(heat, normals, frames, connection, start, end));
  return connection;
}

function assembleRange(
  heat: HeatEquation,
  normals: Float32Array,
  frames: Float32Array,
  { starts, neighbours, transports, degrees }: Connection,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const nx = normals[3 * fan];
    const ny = normals[3 * fan + 1];
    const nz = normals[3 * fan + 2];
    const own = FRAME_FLOATS * fan;
    let degree = 0;
    for (let entry = starts[fan]; entry < starts[fan + 1]; entry++) {
      const neighbour = 3 * neighbours[entry];
      const other = FRAME_FLOATS * neighbours[entry];
      const mx = normals[neighbour] + nx;
      const my = normals[neighbour + 1] + ny;
      const mz = normals[neighbour + 2] + nz;
      const ux = frames[other];
      const uy = frames[other + 1];
      const uz = frames[other + 2];
      // The shortest rotation that takes the normal m there to the normal n here takes a tangent u to u − (n·u)/(1 + n·m)·(m + n).
      const scale = (nx * ux + ny * uy + nz * uz) / Math.max(nx * mx + ny * my + nz * mz, LEAST_ROTATION);
      const tx = ux - scale * mx;
      const ty = uy - scale * my;
      const tz = uz - scale * mz;
      const cosine = tx * frames[own] + ty * frames[own + 1] + tz * frames[own + 2];
      const sine = tx * frames[own + 3] + ty * frames[own + 4] + tz * frames[own + 5];
      const weight = Math.max(heat.weights[entry], LEAST_WEIGHT);
      const perSquare = weight / (cosine * cosine + sine * sine || 1);
      transports[2 * entry] = perSquare * (cosine * cosine - sine * sine);
      transports[2 * entry + 1] = 2 * perSquare * cosine * sine;
      degree += weight;
    }
    degrees[fan] = degree;
  }
}

/** Multiplies the weight of each edge by the mean prominence of its two fans. */
export function* weighConnection(connection: Connection, prominences: Float32Array): Generator<number, void, void> {
  yield* forEachChunk(prominences.length, (start, end) => weighRange(connection, prominences, start, end));
}

function weighRange(
  { starts, neighbours, transports, degrees }: Connection,
  prominences: Float32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    let degree = 0;
    for (let entry = starts[fan]; entry < starts[fan + 1]; entry++) {
      const share = 0.5 * (prominences[fan] + prominences[neighbours[entry]]);
      const x = share * transports[2 * entry];
      const y = share * transports[2 * entry + 1];
      transports[2 * entry] = x;
      transports[2 * entry + 1] = y;
      degree += Math.sqrt(x * x + y * y);
    }
    degrees[fan] = degree;
  }
}

/**
 * Carries the lines of cells to their fans: for each fan the complex number (two floats) by which the line of its cell's seed
 * becomes that of the fan.
 */
export function* cellTransports(
  { transports }: Connection,
  { order, parents, parentEntries }: Cells,
): Generator<number, Float64Array<ArrayBuffer>, void> {
  const carried = new Float64Array(2 * order.length);
  yield* forEachChunk(order.length, (start, end) =>
    carryRange(transports, order, parents, parentEntries, carried, start, end),
  );
  return carried;
}

function carryRange(
  transports: Float32Array,
  order: Uint32Array,
  parents: Int32Array,
  parentEntries: Int32Array,
  carried: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const fan = order[i];
    const parent = parents[fan];
    if (parent < 0) {
      carried[2 * fan] = 1;
      continue;
    }
    // The entry carries from the fan to its parent; the way back is the conjugate.
    const entry = 2 * parentEntries[fan];
    const length = Math.sqrt(transports[entry] ** 2 + transports[entry + 1] ** 2) || 1;
    const cosine = transports[entry] / length;
    const sine = -transports[entry + 1] / length;
    carried[2 * fan] = cosine * carried[2 * parent] - sine * carried[2 * parent + 1];
    carried[2 * fan + 1] = cosine * carried[2 * parent + 1] + sine * carried[2 * parent];
  }
}

/**
 * The connection between cells, whose fans all have the line of the seed. Such fields are stiffer than smooth ones, by the
 * width of a cell in fans; the weights are lower for it.
 */
export function* coarseConnection(
  fine: Connection,
  carried: Float64Array,
  { ofNode, count }: Cells,
  coarse: CoarseGraph,
): Generator<number, Connection, void> {
  const connection: Connection = {
    starts: coarse.starts,
    neighbours: coarse.neighbours,
    transports: new Float32Array(2 * coarse.neighbours.length),
    degrees: new Float64Array(count),
  };
  const softness = Math.sqrt(count / ofNode.length);
  yield* forEachChunk(ofNode.length, (start, end) =>
    sumRange(fine, carried, ofNode, coarse.ofEntry, softness, connection, start, end),
  );
  return connection;
}

function sumRange(
  fine: Connection,
  carried: Float64Array,
  ofNode: Uint32Array,
  ofEntry: Int32Array,
  softness: number,
  { transports, degrees }: Connection,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const cx = softness * carried[2 * fan];
    const cy = softness * carried[2 * fan + 1];
    for (let entry = fine.starts[fan]; entry < fine.starts[fan + 1]; entry++) {
      const target = ofEntry[entry];
      if (target < 0) continue;
      const other = 2 * fine.neighbours[entry];
      const tx = fine.transports[2 * entry];
      const ty = fine.transports[2 * entry + 1];
      // From the other seed to its fan, over the edge, and back to the seed of this cell.
      const x = tx * carried[other] - ty * carried[other + 1];
      const y = tx * carried[other + 1] + ty * carried[other];
      transports[2 * target] += cx * x + cy * y;
      transports[2 * target + 1] += cx * y - cy * x;
      degrees[ofNode[fan]] += softness * Math.sqrt(tx * tx + ty * ty);
    }
  }
}

/** Floats per fan: two unit tangents e₁ and e₂, with e₁ × e₂ the normal. */
export const FRAME_FLOATS = 6;

/** An axis that leans at least this much away from a normal gives a good tangent. */
const LARGEST_COSINE = 0.6;

/** Gives each unit normal (three floats) a deterministic frame of its tangent plane. */
export function* tangentFrames(normals: Float32Array): Generator<number, Float32Array<ArrayBuffer>, void> {
  const frames = new Float32Array(2 * normals.length);
  yield* forEachChunk(normals.length / 3, (start, end) => frameRange(normals, frames, start, end));
  return frames;
}

/** e₁ is the product of the first axis that leans away from the normal and the normal. */
function frameRange(normals: Float32Array, frames: Float32Array, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    const x = normals[3 * fan];
    const y = normals[3 * fan + 1];
    const z = normals[3 * fan + 2];
    let ux = 0;
    let uy = 0;
    let uz = 0;
    if (Math.abs(x) < LARGEST_COSINE) {
      uy = -z;
      uz = y;
    } else if (Math.abs(y) < LARGEST_COSINE) {
      ux = z;
      uz = -x;
    } else {
      ux = -y;
      uy = x;
    }
    const scale = 1 / Math.sqrt(ux * ux + uy * uy + uz * uz);
    ux *= scale;
    uy *= scale;
    uz *= scale;
    const i = FRAME_FLOATS * fan;
    frames[i] = ux;
    frames[i + 1] = uy;
    frames[i + 2] = uz;
    frames[i + 3] = y * uz - z * uy;
    frames[i + 4] = z * ux - x * uz;
    frames[i + 5] = x * uy - y * ux;
  }
}
