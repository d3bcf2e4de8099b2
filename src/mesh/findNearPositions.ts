import { forEachChunk } from '../slices/forEachChunk.js';
import { hashWords } from './hashWords.js';

/** What `findNearPositions` returns. */
export interface NearPositions {
  /** Those that may be near another one, in their order. */
  near: Uint32Array<ArrayBuffer>;
  /** Hash slots visited: a machine-independent measure of the time taken. */
  steps: number;
}

/** Side of a cell of the grid, in tolerances. Most boxes lie in one cell, and few cells hold more than one. */
const CELL = 16;

/** Half a side of the box around a position, in tolerances. Above one half, so that rounding separates no boxes that touch. */
const REACH = 0.51;

/**
 * Finds the positions that may differ from another one by no more than `tolerance` along each axis. Most others are left out,
 * at a fraction of what it costs to search their neighbourhood: two near positions have boxes of one tolerance that touch, so
 * some cell of a coarse grid holds a part of both. Which cells do is kept in a hash table that takes collisions for near.
 *
 * @param vertices which positions, by number
 * @param tolerance above 0, and not below 2⁻⁴⁰ of the extent of the positions
 */
export function* findNearPositions(
  positions: Float32Array,
  vertices: Uint32Array,
  tolerance: number,
): Generator<number, NearPositions, void> {
  let size = 16;
  while (size < 8 * vertices.length) size *= 2;
  const table = new Uint32Array(size);
  const isNear = new Uint8Array(vertices.length);
  let steps = 0;
  yield* forEachChunk(vertices.length, (start, end) => {
    steps += enterRange(positions, vertices, tolerance, table, isNear, start, end);
  });
  const near = new Uint32Array(vertices.length);
  let count = 0;
  for (let i = 0; i < vertices.length; i++) if (isNear[i] === 1) near[count++] = vertices[i];
  return { near: near.subarray(0, count), steps };
}

/** Enters positions into `table` (entry + 1, so that 0 means empty) and marks those that meet. Returns the slots visited. */
function enterRange(
  positions: Float32Array,
  vertices: Uint32Array,
  tolerance: number,
  table: Uint32Array,
  isNear: Uint8Array,
  start: number,
  end: number,
): number {
  const mask = table.length - 1;
  const scale = 1 / (CELL * tolerance);
  const reach = REACH / CELL;
  let steps = 0;
  for (let i = start; i < end; i++) {
    // The planes through the origin, where many borders lie, run through the middle of cells.
    const x = positions[3 * vertices[i]] * scale + 0.5;
    const y = positions[3 * vertices[i] + 1] * scale + 0.5;
    const z = positions[3 * vertices[i] + 2] * scale + 0.5;
    const lastX = Math.floor(x + reach);
    const lastY = Math.floor(y + reach);
    const lastZ = Math.floor(z + reach);
    for (let cellZ = Math.floor(z - reach); cellZ <= lastZ; cellZ++) {
      for (let cellY = Math.floor(y - reach); cellY <= lastY; cellY++) {
        for (let cellX = Math.floor(x - reach); cellX <= lastX; cellX++) {
          const slot = hashWords(cellX, cellY, cellZ) & mask;
          const other = table[slot] - 1;
          steps++;
          if (other < 0) table[slot] = i + 1;
          else isNear[i] = isNear[other] = 1;
        }
      }
    }
  }
  return steps;
}
