import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { buildTriangleAdjacency, consistentTwins } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, nextCorner } from '../../../../src/mesh/corners.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { book, finish, meshOf } from '../meshes.js';

/** The twins of a mesh before and after. */
function twinsOf(mesh: TriangleMesh) {
  const adjacency = finish(buildTriangleAdjacency(mesh));
  const before = adjacency.twins.slice();
  const after = finish(consistentTwins(adjacency));
  return { ...adjacency, before, after };
}

const SQUARE = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];

describe('two triangles with a common edge', () => {
  test('stay neighbours if they are wound alike', () => {
    const { before, after, inconsistentEdges } = twinsOf(
      meshOf(SQUARE, [
        [0, 1, 2],
        [0, 2, 3],
      ]),
    );
    expect(inconsistentEdges).toBe(0);
    expect([...after]).toEqual([...before]);
    expect([...after]).toEqual([NO_TWIN, NO_TWIN, 3, 2, NO_TWIN, NO_TWIN]);
  });

  test('are separated if they are not, and the given twins stay unchanged', () => {
    const { before, after, twins, inconsistentEdges } = twinsOf(
      meshOf(SQUARE, [
        [0, 1, 2],
        [0, 3, 2],
      ]),
    );
    expect(inconsistentEdges).toBe(1);
    expect([...after]).toEqual(Array(6).fill(NO_TWIN));
    expect([...twins]).toEqual([...before]);
    expect([...before].filter((twin) => twin !== NO_TWIN)).toHaveLength(2);
  });
});

test('the result is never the given array', () => {
  for (const mesh of [
    meshOf(SQUARE, [
      [0, 1, 2],
      [0, 2, 3],
    ]),
    book(4),
  ]) {
    const { twins, after } = twinsOf(mesh);
    expect(after).not.toBe(twins);
    expect(after.buffer).not.toBe(twins.buffer);
  }
});

test('exactly the edges that both triangles traverse in one direction lose their twins', () => {
  const soups = fc.array(fc.tuple(fc.nat(7), fc.nat(7), fc.nat(7)), { minLength: 1, maxLength: 30 });
  let dropped = 0;
  fc.assert(
    fc.property(soups, (triangles) => {
      const mesh: TriangleMesh = {
        positions: Float32Array.from({ length: 24 }, (_, i) => Math.sin(7 * i * i + i)),
        indices: Uint32Array.from(triangles.flat()),
      };
      const { before, after } = twinsOf(mesh);
      for (const [corner, twin] of before.entries()) {
        if (twin === NO_TWIN) {
          expect(after[corner]).toBe(NO_TWIN);
          continue;
        }
        const isOpposite =
          mesh.indices[corner] === mesh.indices[nextCorner(twin)] &&
          mesh.indices[twin] === mesh.indices[nextCorner(corner)];
        expect(after[corner]).toBe(isOpposite ? twin : NO_TWIN);
        if (!isOpposite) dropped++;
      }
    }),
    { seed: 3, numRuns: 200 },
  );
  expect(dropped).toBeGreaterThan(0);
});
