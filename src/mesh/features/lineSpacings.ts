import {
  BORDER,
  CONTRARY,
  LOW_FLAGS,
  POINT_BITS,
  POINT_MASK,
  PRIMITIVE_WORDS,
  SPACING_STEPS,
} from '../bake/outlineLayout.js';
import { asPhase, chunkPhase } from '../phases.js';

/** The surface whose lines are counted. Plain data: it is posted to the worker. */
export interface LinedSurface {
  /** x, y, z of each point. */
  positions: Float32Array<ArrayBuffer>;
  /** x, y, z of each point's unit normal. */
  normals: Float32Array<ArrayBuffer>;
  /** See `outlineLayout.ts`. */
  primitives: Uint32Array<ArrayBuffer>;
  triangleCount: number;
  edgeCount: number;
  /** Radius of the bounding sphere. */
  radius: number;
}

/** The number of lines through a cube, from side to side, from which on they are a crowd: more than a rod, a leaf or a corner has. */
const MANY = 6;
/** Cells along a side of the bounding cube, at the coarsest and at the finest level. */
const FEWEST = 4;
const MOST = 128;
/** Cells per primitive at the finest level. */
const ROOM = 8;
/** The greatest number of steps that a primitive has room for. */
const MOST_STEPS = 255;

/** A cube of cells. */
interface LineGrid {
  positions: Float32Array;
  /** Cells along a side. */
  side: number;
  /** Size of a cell. */
  size: number;
  /** The corner from which cells are counted. */
  low: readonly number[];
  /** For each cell the length of the lines in it, and later their spacing. */
  cells: Float32Array;
}

/**
 * Measures how far apart the outlines of a surface lie around each of its triangles and edges, and writes it into the primitives. It is the
 * size of the smallest cube that `MANY` lines cross, divided by their number. A border counts with its length, another edge with the share
 * of the directions from which it is a contour, and a triangle with what it has of contours on average.
 *
 * @returns the primitives
 */
export function* lineSpacings(surface: LinedSurface): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const { positions, primitives, triangleCount, edgeCount } = surface;
  const count = triangleCount + edgeCount;
  const lengths = new Float32Array(count);
  const grid = gridAround(positions, count);
  yield* chunkPhase(triangleCount, 0, 0.3, (start, end) => addTriangles(surface, lengths, grid, start, end));
  yield* chunkPhase(edgeCount, 0.3, 0.4, (start, end) => addEdges(surface, lengths, grid, start, end));
  yield* asPhase(measureCells(grid), 0.4, 0.7);
  yield* chunkPhase(count, 0.7, 1, (start, end) => writeSpacings(surface, lengths, grid, start, end));
  return primitives;
}

function gridAround(positions: Float32Array, primitives: number): LineGrid {
  const low = [Infinity, Infinity, Infinity];
  const high = low.map((value) => -value);
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  let side = FEWEST;
  while (side < MOST && side ** 3 < ROOM * primitives) side *= 2;
  const size = Math.max(...high.map((value, axis) => value - low[axis])) / side || 1;
  return { positions, side, size, low, cells: new Float32Array(side ** 3) };
}

/**
 * Adds a length, spread over the cells on the way between two points. Returns the mean of these cells.
 *
 * @param length 0 to read only
 */
function spread(grid: LineGrid, a: number, b: number, length: number): number {
  const { positions, side, size, low, cells } = grid;
  const count = Math.ceil(distance(positions, a, b) / size) || 1;
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const share = (i + 0.5) / count;
    let cell = 0;
    for (let axis = 0; axis < 3; axis++) {
      const from = positions[3 * a + axis];
      const place = from + share * (positions[3 * b + axis] - from) - low[axis];
      cell = side * cell + Math.min(Math.floor(place / size), side - 1);
    }
    cells[cell] += length / count;
    sum += cells[cell];
  }
  return sum / count;
}

function addTriangles(
  { positions, normals, primitives }: LinedSurface,
  lengths: Float32Array,
  grid: LineGrid,
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const [a, b, c] = pointsOf(primitives, triangle);
    const ab = distance(positions, a, b);
    const bc = distance(positions, b, c);
    const ca = distance(positions, c, a);
    const half = 0.5 * (ab + bc + ca);
    const area = Math.sqrt(Math.max(half * (half - ab) * (half - bc) * (half - ca), 0));
    // A triangle without area has no curvature.
    if (area === 0) continue;
    const curvature = Math.max(
      distance(normals, a, b) / ab,
      distance(normals, b, c) / bc,
      distance(normals, c, a) / ca,
    );
    const length = (area * curvature) / Math.PI;
    if (length === 0) continue;
    lengths[triangle] = length;
    spread(grid, a, b, length / 3);
    spread(grid, b, c, length / 3);
    spread(grid, c, a, length / 3);
  }
}

function addEdges(
  { positions, normals, primitives, triangleCount }: LinedSurface,
  lengths: Float32Array,
  grid: LineGrid,
  start: number,
  end: number,
): void {
  for (let edge = triangleCount + start; edge < triangleCount + end; edge++) {
    const [a, b, c] = pointsOf(primitives, edge);
    const flags = primitives[PRIMITIVE_WORDS * edge] >>> POINT_BITS;
    const chord = Math.min(distance(normals, a, c) / 2, 1);
    const turned = (2 / Math.PI) * Math.asin(flags & CONTRARY ? Math.sqrt(1 - chord * chord) : chord);
    lengths[edge] = (flags & BORDER ? 1 : turned) * distance(positions, a, b);
    spread(grid, a, b, lengths[edge]);
  }
}

/** Replaces the length of lines in each cell by their spacing, at most the side of the whole cube. */
function* measureCells({ cells, side, size }: LineGrid): Generator<number, void, void> {
  // The cells of each level are twice as large as those of the one before it.
  const levels = [cells.slice()];
  for (let n = side; n > FEWEST; n /= 2) {
    const fine = levels[levels.length - 1];
    const coarse = new Float32Array((n / 2) ** 3);
    yield* chunkPhase(fine.length, 0.5, 0.5, (start, end) => sumCells(fine, coarse, n, start, end));
    levels.push(coarse);
  }
  yield* chunkPhase(cells.length, 0.5, 1, (start, end) => measureRange(cells, levels, side, size, start, end));
}

/** Adds cells, `side` of them along a side, to those twice as large. */
function sumCells(fine: Float32Array, coarse: Float32Array, side: number, start: number, end: number): void {
  const half = side / 2;
  for (let i = start; i < end; i++) {
    if (fine[i] === 0) continue;
    const [x, y, z] = [Math.floor(i / side / side), Math.floor(i / side) % side, i % side];
    coarse[half * (half * (x >> 1) + (y >> 1)) + (z >> 1)] += fine[i];
  }
}

function measureRange(
  cells: Float32Array,
  levels: readonly Float32Array[],
  side: number,
  size: number,
  start: number,
  end: number,
): void {
  for (let cell = start; cell < end; cell++) {
    if (cells[cell] === 0) continue;
    const place = [Math.floor(cell / side / side), Math.floor(cell / side) % side, cell % side];
    cells[cell] = side * size;
    let last = MANY;
    for (let k = 0; k < levels.length; k++) {
      const width = size * 2 ** k;
      const lines = lengthAround(levels[k], side >> k, place, 2 ** k) / width;
      if (lines >= MANY) {
        // The cube that exactly so many lines cross is between the cells of two levels in size.
        cells[cell] = last < MANY ? (width / MANY) * 2 ** ((MANY - lines) / (lines - last)) : width / lines;
        break;
      }
      last = lines;
    }
  }
}

/** The length of lines in a cell of a level that would lie around the middle of a cell of the finest level. */
function lengthAround(level: Float32Array, side: number, place: readonly number[], scale: number): number {
  let sum = 0;
  for (let corner = 0; corner < 8; corner++) {
    let cell = 0;
    let share = 1;
    for (let axis = 0; axis < 3; axis++) {
      const at = (place[axis] + 0.5) / scale - 0.5;
      const first = Math.floor(at);
      const isNext = (corner >> axis) & 1;
      share *= isNext ? at - first : 1 - at + first;
      cell = side * cell + Math.min(Math.max(first + isNext, 0), side - 1);
    }
    sum += share * level[cell];
  }
  return sum;
}

function writeSpacings(
  { primitives, triangleCount, radius }: LinedSurface,
  lengths: Float32Array,
  grid: LineGrid,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    if (lengths[i] === 0) continue;
    const [a, b, c] = pointsOf(primitives, i);
    const spacing =
      i < triangleCount
        ? (spread(grid, a, b, 0) + spread(grid, b, c, 0) + spread(grid, c, a, 0)) / 3
        : spread(grid, a, b, 0);
    const step = Math.min(Math.max(Math.round(SPACING_STEPS * Math.log2(radius / spacing)), 0), MOST_STEPS);
    const word = PRIMITIVE_WORDS * i;
    primitives[word + 2] |= (step & LOW_FLAGS) << POINT_BITS;
    primitives[word + 3] |= (step >> 4) << POINT_BITS;
  }
}

function pointsOf(primitives: Uint32Array, primitive: number): [a: number, b: number, c: number] {
  const word = PRIMITIVE_WORDS * primitive;
  return [primitives[word] & POINT_MASK, primitives[word + 1] & POINT_MASK, primitives[word + 2] & POINT_MASK];
}

function distance(positions: Float32Array, a: number, b: number): number {
  const x = positions[3 * b] - positions[3 * a];
  const y = positions[3 * b + 1] - positions[3 * a + 1];
  const z = positions[3 * b + 2] - positions[3 * a + 2];
  return Math.sqrt(x * x + y * y + z * z);
}
