import { hashWords } from './hashWords.js';
import { forEachChunk, release } from './phases.js';

/** The result of `weldPositions`. */
export interface Weld {
  /** For each vertex the first vertex at exactly the same position: its canonical vertex. */
  canonical: Uint32Array<ArrayBuffer>;
  /** Hash table slots visited: a machine-independent measure of the time taken. */
  steps: number;
}

const NEGATIVE_ZERO_BITS = 0x80000000;

/** The bits of a float, with −0 folded into 0 so that equal coordinates have equal bits. */
const fold = (bits: number): number => (bits === NEGATIVE_ZERO_BITS ? 0 : bits);

/**
 * Finds the vertices that lie at exactly the same position. Vertices are split along the seams of uvs, normals and colours,
 * but the surface continues across them. There is no tolerance here; see `joinBorders`.
 *
 * The hash table uses open addressing with linear probing, at a load of at most one half. The expected time is O(V).
 */
export function* weldPositions(positions: Float32Array<ArrayBuffer>): Generator<number, Weld, void> {
  const vertexCount = positions.length / 3;
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const canonical = new Uint32Array(vertexCount);
  let size = 16;
  while (size < 2 * vertexCount) size *= 2;
  const table = new Uint32Array(size);
  let steps = 0;
  yield* forEachChunk(vertexCount, (start, end) => {
    steps += weldRange(bits, table, canonical, start, end);
  });
  release(table);
  return { canonical, steps };
}

/** Enters vertices into `table` (vertex + 1; 0 is an empty slot). Returns the number of slots visited. */
function weldRange(bits: Uint32Array, table: Uint32Array, canonical: Uint32Array, start: number, end: number): number {
  const mask = table.length - 1;
  let steps = 0;
  for (let vertex = start; vertex < end; vertex++) {
    const x = fold(bits[3 * vertex]);
    const y = fold(bits[3 * vertex + 1]);
    const z = fold(bits[3 * vertex + 2]);
    let slot = hashWords(x, y, z) & mask;
    for (;;) {
      steps++;
      const other = table[slot] - 1;
      if (other < 0) {
        table[slot] = vertex + 1;
        canonical[vertex] = vertex;
        break;
      }
      if (fold(bits[3 * other]) === x && fold(bits[3 * other + 1]) === y && fold(bits[3 * other + 2]) === z) {
        canonical[vertex] = other;
        break;
      }
      slot = (slot + 1) & mask;
    }
  }
  return steps;
}
