import { asPhase, forEachChunk } from '../phases.js';

/** Largest number of cells along an axis. */
const MOST_ALONG = 64;

/** Triangles in the order of their cubic cells. */
export interface SortedTriangles {
  /** The corners of all triangles, cell by cell. */
  indices: Uint32Array<ArrayBuffer>;
  /** The start of each cell in `indices`, then the end of the last one. Cells may be empty. */
  starts: Uint32Array;
}

/** A grid of cells over a box. */
interface Grid {
  min: number[];
  /** Cells per unit. */
  scale: number;
  along: number[];
}

/**
 * Sorts triangles into cubic cells by their centres, so that each cell can be simplified alone: triangles near each other in space may be
 * far apart in a file.
 *
 * @param size of a cell, in object units; larger where there would be more than 64 along an axis
 * @param shift shift of the grid in [0, 1), as a share of a cell
 */
export function* sortIntoCells(
  positions: Float32Array,
  indices: Uint32Array,
  size: number,
  shift: number,
): Generator<number, SortedTriangles, void> {
  const count = indices.length / 3;
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  yield* asPhase(
    forEachChunk(positions.length / 3, (start, end) => widen(min, max, positions, start, end)),
    0,
    0.2,
  );
  const grid = gridOver(min, max, size, shift);
  const cells = new Uint32Array(count);
  const places = new Uint32Array(grid.along[0] * grid.along[1] * grid.along[2] + 1);
  yield* asPhase(
    forEachChunk(count, (start, end) => findCells(cells, places, positions, indices, grid, start, end)),
    0.2,
    0.6,
  );
  let total = 0;
  for (let cell = 0; cell < places.length; cell++) {
    const inCell = places[cell];
    places[cell] = total;
    total += inCell;
  }
  const starts = places.map((place) => 3 * place);
  const sorted = new Uint32Array(indices.length);
  yield* asPhase(
    forEachChunk(count, (start, end) => place(sorted, places, cells, indices, start, end)),
    0.6,
    1,
  );
  return { indices: sorted, starts };
}

function gridOver(min: readonly number[], max: readonly number[], size: number, shift: number): Grid {
  const extent = Math.max(...max.map((value, axis) => value - min[axis]), 0);
  const edge = Math.max(size, extent / (MOST_ALONG - 1)) || 1;
  return {
    min: min.map((value) => value - shift * edge),
    scale: 1 / edge,
    along: max.map((value, axis) => Math.floor((value - min[axis]) / edge + shift) + 1),
  };
}

function widen(min: number[], max: number[], positions: Float32Array, start: number, end: number): void {
  for (let i = 3 * start; i < 3 * end; i++) {
    const axis = i % 3;
    const value = positions[i];
    if (value < min[axis]) min[axis] = value;
    if (value > max[axis]) max[axis] = value;
  }
}

function findCells(
  cells: Uint32Array,
  sizes: Uint32Array,
  positions: Float32Array,
  indices: Uint32Array,
  { min, scale, along }: Grid,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const [a, b, c] = [3 * indices[3 * i], 3 * indices[3 * i + 1], 3 * indices[3 * i + 2]];
    let cell = 0;
    for (let axis = 2; axis >= 0; axis--) {
      const centre = (positions[a + axis] + positions[b + axis] + positions[c + axis]) / 3;
      const place = Math.floor((centre - min[axis]) * scale);
      cell = cell * along[axis] + Math.min(along[axis] - 1, Math.max(0, place));
    }
    cells[i] = cell;
    sizes[cell]++;
  }
}

function place(
  sorted: Uint32Array,
  places: Uint32Array,
  cells: Uint32Array,
  indices: Uint32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const to = 3 * places[cells[i]]++;
    sorted[to] = indices[3 * i];
    sorted[to + 1] = indices[3 * i + 1];
    sorted[to + 2] = indices[3 * i + 2];
  }
}
