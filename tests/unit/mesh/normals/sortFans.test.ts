import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { NO_TWIN, nextCorner } from '../../../../src/mesh/corners.js';
import { sortFans } from '../../../../src/mesh/normals/fans.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { surfaceOf } from '../features/surfaces.js';
import { fan, finish } from '../meshes.js';
import { patch, together } from '../shapes.js';

/** Fans per block. */
const BLOCK = 16384;

/** Largest number of edges that counts. */
const MOST_EDGES = 31;

/** The fans of a mesh before and after, with the number of edges of each one before. */
function sorted(mesh: TriangleMesh) {
  const { sharpTwins: twins, fans } = surfaceOf(mesh);
  const sizes = Array<number>(fans.count).fill(0);
  for (const [corner, twin] of twins.entries()) {
    // Each edge once, for both of its ends.
    if (twin !== NO_TWIN && twin < corner) continue;
    sizes[fans.ofCorner[corner]]++;
    sizes[fans.ofCorner[nextCorner(corner)]]++;
  }
  return { fans, sizes, after: finish(sortFans({ twins, fans })) };
}

/** Compares `sortFans` with an ordinary sort. */
function expectSorted({ fans, sizes, after }: ReturnType<typeof sorted>): void {
  const expected: number[] = [];
  for (let first = 0; first < fans.count; first += BLOCK) {
    const block = Array.from({ length: Math.min(BLOCK, fans.count - first) }, (_, i) => first + i);
    const key = (number: number) => Math.min(sizes[number], MOST_EDGES);
    expected.push(...block.sort((a, b) => key(a) - key(b) || a - b));
  }
  expect([...after.order]).toEqual(expected);
  expect([...after.sizes]).toEqual([...expected.map((number) => sizes[number]), 0]);
  expect([...after.order].map((fan) => after.numbers[fan])).toEqual([...after.order.keys()]);
}

test('fans are sorted by their number of edges, and those of equally many keep their order', () => {
  const result = sorted(patch(5, 4, (u, v) => [u, v, 0]));
  expectSorted(result);
  expect(new Set(result.after.sizes.slice(0, -1)).size).toBeGreaterThan(3);
});

test('fans stay within their block', () => {
  const result = sorted(patch(150, 149, (u, v) => [u, v, 0]));
  expect(result.fans.count).toBeGreaterThan(BLOCK);
  expectSorted(result);
  // Both blocks begin with fans of few edges, those at the border.
  expect(result.after.sizes[0]).toBeLessThan(4);
  expect(result.after.sizes[BLOCK]).toBeLessThan(4);
  expect(result.after.sizes[BLOCK - 1]).toBeGreaterThan(4);
});

describe('fans of very many edges', () => {
  test.each([MOST_EDGES - 1, MOST_EDGES, MOST_EDGES + 1, 1000])(
    'one of %d comes last, with its own number',
    (count) => {
      const result = sorted(fan(count));
      expectSorted(result);
      expect(result.after.sizes.at(-2)).toBe(count);
    },
  );
});

test('fans of more edges than count keep their order among themselves', () => {
  const apart = (count: number, i: number) => {
    const { positions, indices } = fan(count);
    return { positions: positions.map((value, k) => (k % 3 === 0 ? value + 3 * i : value)), indices };
  };
  const order = (...counts: number[]) => [...sorted(together(...counts.map(apart))).after.sizes.slice(-3, -1)];
  expect(order(MOST_EDGES + 9, MOST_EDGES)).toEqual([MOST_EDGES + 9, MOST_EDGES]);
  expect(order(MOST_EDGES + 9, MOST_EDGES - 1)).toEqual([MOST_EDGES - 1, MOST_EDGES + 9]);
});

test('the fans of any triangles are sorted', () => {
  const soups = fc.array(fc.tuple(fc.nat(8), fc.nat(8), fc.nat(8)), { minLength: 1, maxLength: 40 });
  fc.assert(
    fc.property(soups, (triangles) =>
      expectSorted(
        sorted({
          positions: Float32Array.from({ length: 27 }, (_, i) => Math.sin(7 * i * i + i)),
          indices: Uint32Array.from(triangles.flat()),
        }),
      ),
    ),
    { seed: 5, numRuns: 100 },
  );
});
