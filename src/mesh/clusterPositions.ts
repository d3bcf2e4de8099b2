import { disjointSets, join, rootOf } from './disjointSets.js';
import { hashWords } from './hashWords.js';
import { asPhase, chunkPhase, forEachChunk } from './phases.js';

/** The result of `clusterPositions`. */
export interface Clusters {
  /** For each entry of `vertices` the first entry of its cluster. */
  first: Uint32Array<ArrayBuffer>;
  /** Hash slots and positions visited: a machine-independent measure of the time taken. */
  steps: number;
}

/** Positions sorted into cubic cells whose side is the tolerance. */
interface Cells {
  /** Cell coordinates of each position: x, y, z. */
  coordinates: Float64Array;
  /** A hash table of the numbers of cells + 1; 0 is an empty slot. */
  table: Uint32Array;
  /** One position of each cell. */
  sample: Uint32Array;
  /** The cell of each position. */
  ofPosition: Uint32Array;
  count: number;
  /** The positions of cell i are members[starts[i]] … members[starts[i + 1] − 1]. */
  starts: Uint32Array;
  members: Uint32Array;
  steps: number;
}

/** Half of the 26 neighbours of a cell. The other half is covered from the other side. */
const NEIGHBOURS = Array.from({ length: 27 }, (_, i) => [
  (i % 3) - 1,
  (Math.floor(i / 3) % 3) - 1,
  Math.floor(i / 9) - 1,
])
  .slice(14)
  .flat();

/**
 * Finds the connected components of positions, where two positions are connected if they differ by no more than `tolerance`
 * along each axis. The result depends neither on the order of the positions nor on the grid.
 *
 * All positions in one cell of the grid are connected. To find out whether two neighbouring cells are connected, the cells are
 * halved repeatedly (`touch`), so that a crowded cell costs little more than its number of positions.
 *
 * @param vertices the numbers of the positions to look at
 * @param tolerance above 0, and not below 2⁻⁴⁰ of the extent of the positions
 */
export function* clusterPositions(
  positions: Float32Array,
  vertices: Uint32Array,
  tolerance: number,
): Generator<number, Clusters, void> {
  const count = vertices.length;
  const points = new Float32Array(3 * count);
  const min = [Infinity, Infinity, Infinity];
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * vertices[i] + axis];
      points[3 * i + axis] = value;
      min[axis] = Math.min(min[axis], value);
    }
  }
  const cells = yield* asPhase(sortIntoCells(points, min, tolerance), 0, 0.4);
  const parents = disjointSets(count);
  yield* chunkPhase(cells.count, 0.4, 1, (start, end) => connectRange(points, cells, parents, tolerance, start, end));
  const first = new Uint32Array(count);
  for (let i = 0; i < count; i++) first[i] = rootOf(parents, i);
  return { first, steps: cells.steps };
}

function* sortIntoCells(
  points: Float32Array,
  min: readonly number[],
  tolerance: number,
): Generator<number, Cells, void> {
  const count = points.length / 3;
  let size = 16;
  while (size < 2 * count) size *= 2;
  const cells: Cells = {
    coordinates: new Float64Array(3 * count),
    table: new Uint32Array(size),
    sample: new Uint32Array(count),
    ofPosition: new Uint32Array(count),
    count: 0,
    starts: new Uint32Array(count + 1),
    members: new Uint32Array(count),
    steps: 0,
  };
  yield* forEachChunk(count, (start, end) => enterRange(points, min, tolerance, cells, start, end));
  const { starts, members, ofPosition } = cells;
  for (let i = 0; i < count; i++) starts[ofPosition[i]]++;
  for (let cell = 0, end = 0; cell <= cells.count; cell++) {
    end += starts[cell];
    starts[cell] = end;
  }
  for (let i = count - 1; i >= 0; i--) members[--starts[ofPosition[i]]] = i;
  return cells;
}

function enterRange(
  points: Float32Array,
  min: readonly number[],
  tolerance: number,
  cells: Cells,
  start: number,
  end: number,
): void {
  const { coordinates, table, sample, ofPosition } = cells;
  for (let i = start; i < end; i++) {
    for (let axis = 0; axis < 3; axis++) {
      coordinates[3 * i + axis] = Math.floor((points[3 * i + axis] - min[axis]) / tolerance);
    }
    const slot = findSlot(cells, coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
    if (table[slot] === 0) {
      sample[cells.count] = i;
      table[slot] = ++cells.count;
    }
    ofPosition[i] = table[slot] - 1;
  }
}

/** The slot of the hash table that holds the cell with these coordinates, or the empty one where it would be. */
function findSlot(cells: Cells, x: number, y: number, z: number): number {
  const { coordinates, table, sample } = cells;
  const mask = table.length - 1;
  for (let slot = hashWords(x, y, z) & mask; ; slot = (slot + 1) & mask) {
    cells.steps++;
    if (table[slot] === 0) return slot;
    const other = 3 * sample[table[slot] - 1];
    if (coordinates[other] === x && coordinates[other + 1] === y && coordinates[other + 2] === z) return slot;
  }
}

/** Connects the positions in each cell of a range with each other and with those in the neighbouring cells. */
function connectRange(
  points: Float32Array,
  cells: Cells,
  parents: Uint32Array,
  tolerance: number,
  start: number,
  end: number,
): void {
  const { coordinates, table, sample, starts, members } = cells;
  const membersOf = (cell: number): Uint32Array => members.subarray(starts[cell], starts[cell + 1]);
  for (let cell = start; cell < end; cell++) {
    const own = sample[cell];
    for (let i = starts[cell]; i < starts[cell + 1]; i++) join(parents, own, members[i]);
    for (let i = 0; i < NEIGHBOURS.length; i += 3) {
      const x = coordinates[3 * own] + NEIGHBOURS[i];
      const y = coordinates[3 * own + 1] + NEIGHBOURS[i + 1];
      const z = coordinates[3 * own + 2] + NEIGHBOURS[i + 2];
      const neighbour = table[findSlot(cells, x, y, z)] - 1;
      if (neighbour < 0 || rootOf(parents, own) === rootOf(parents, sample[neighbour])) continue;
      if (touch(points, membersOf(cell), membersOf(neighbour), tolerance, cells)) {
        join(parents, own, sample[neighbour]);
      }
    }
  }
}

/**
 * Whether some position of `a` and some position of `b` differ by no more than `tolerance` along each axis. If the bounding
 * boxes of the two do not decide it, the wider one is halved.
 */
function touch(
  points: Float32Array,
  a: Uint32Array,
  b: Uint32Array,
  tolerance: number,
  counter: { steps: number },
): boolean {
  counter.steps += a.length + b.length;
  let isApart = false;
  let isClose = true;
  let widest = 0;
  let axisToHalve = 0;
  let middle = 0;
  let halvesA = true;
  for (let axis = 0; axis < 3; axis++) {
    const [lowA, highA] = span(points, a, axis);
    const [lowB, highB] = span(points, b, axis);
    if (lowB - highA > tolerance || lowA - highB > tolerance) isApart = true;
    if (highB - lowA > tolerance || highA - lowB > tolerance) isClose = false;
    if (highA - lowA > widest) {
      [widest, axisToHalve, middle, halvesA] = [highA - lowA, axis, (lowA + highA) / 2, true];
    }
    if (highB - lowB > widest) {
      [widest, axisToHalve, middle, halvesA] = [highB - lowB, axis, (lowB + highB) / 2, false];
    }
  }
  if (isApart || isClose) return !isApart;
  const isLow = (i: number): boolean => points[3 * i + axisToHalve] <= middle;
  const isHigh = (i: number): boolean => !isLow(i);
  return halvesA
    ? touch(points, a.filter(isLow), b, tolerance, counter) || touch(points, a.filter(isHigh), b, tolerance, counter)
    : touch(points, a, b.filter(isLow), tolerance, counter) || touch(points, a, b.filter(isHigh), tolerance, counter);
}

/** The least and the greatest coordinate along an axis. */
function span(points: Float32Array, list: Uint32Array, axis: number): [low: number, high: number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < list.length; i++) {
    const value = points[3 * list[i] + axis];
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}
