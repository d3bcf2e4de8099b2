import { hashWords } from './hashWords.js';
import { forEachChunk } from './phases.js';

/** The result of `findNearPositions`. */
export interface NearPositions {
  /** The entries of `vertices` that may be near another position, in the same order. */
  near: Uint32Array<ArrayBuffer>;
  /** Hash slots visited: a machine-independent measure of the time taken. */
  steps: number;
}

/** Side of a grid cell, in tolerances. At this size most boxes lie in one cell, and few cells hold two. */
const CELL = 16;

/** Half a side of the box around a position, in tolerances. Above 0.5, so that rounding cannot separate boxes that touch. */
const REACH = 0.51;

/**
 * Finds the positions that may differ from another one by no more than `tolerance` along each axis. It leaves out most of the
 * others, at a fraction of the cost of a search of their neighbourhood. Each position has a box around it with sides of one
 * tolerance. The boxes of two near positions touch, so some cell of a coarse grid holds a part of both. Cells are kept in a
 * hash table; positions whose cells collide in it count as near.
 *
 * @param vertices the numbers of the positions to look at
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

/** Enters positions into `table` (entry + 1; 0 is an empty slot) and marks those that meet. Returns the count of slots visited. */
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
    // The offset puts the planes through the origin, where many borders lie, into the middle of cells.
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
