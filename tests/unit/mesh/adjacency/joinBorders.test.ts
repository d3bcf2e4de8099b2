import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { buildTriangleAdjacency } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import type { Nearness } from '../../../../src/mesh/adjacency/joinBorders.js';
import { NO_TWIN } from '../../../../src/mesh/corners.js';
import { finish, meshOf } from '../meshes.js';
import { noise, torus } from '../shapes.js';

const NEAR: Nearness = { tolerance: 1e-3, rounding: 1e-6 };

type Row = readonly number[];

/** Two triangles that share an edge but for `gap`, along x. */
const split = (gap: number) =>
  meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [1 + gap, 0, 0],
      [gap, 1, 0],
      [1, 1, 0],
    ],
    [
      [0, 1, 2],
      [4, 3, 5],
    ],
  );

describe('borders within the tolerance', () => {
  test.each([
    [0, 4],
    [0.5e-3, 4],
    [1.5e-3, 6],
  ])('with a gap of %f there are %i border edges', (gap, borderEdges) => {
    expect(finish(buildTriangleAdjacency(split(gap), NEAR)).borderEdges).toBe(borderEdges);
  });

  test('are joined in a copy: the indices of the mesh stay unchanged', () => {
    const mesh = split(0.5e-3);
    const indices = [...mesh.indices];
    const { canonicalCorners } = finish(buildTriangleAdjacency(mesh, NEAR));
    expect(new Set(canonicalCorners).size).toBe(4);
    expect([...mesh.indices]).toEqual(indices);
  });

  test('are left alone if the tolerance is 0', () => {
    expect(finish(buildTriangleAdjacency(split(1e-7))).borderEdges).toBe(6);
  });

  test('contradicting windings are noticed across the gap', () => {
    const mesh = split(0.5e-3);
    mesh.indices.set([3, 4, 5], 3);
    expect(finish(buildTriangleAdjacency(mesh, NEAR))).toMatchObject({ borderEdges: 4, inconsistentEdges: 1 });
  });

  test('three that meet are matched as a non-manifold edge', () => {
    const mesh = meshOf(
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 4e-4],
        [1, 0, 4e-4],
        [0, -1, 0.1],
        [0, 4e-4, 0],
        [1, 4e-4, 0],
        [0, 0, 1],
      ],
      [
        [0, 1, 2],
        [4, 3, 5],
        [7, 6, 8],
      ],
    );
    const { twins, ...counts } = finish(buildTriangleAdjacency(mesh, NEAR));
    expect(counts).toMatchObject({ borderEdges: 6, nonManifoldEdges: 1 });
    expect([...twins].filter((twin) => twin !== NO_TWIN).length).toBe(2);
  });

  test('stay apart where a chain of them is wider than four tolerances', () => {
    const fins = (count: number) =>
      meshOf(
        Array.from({ length: count }, (_, i) => [
          [0.9e-3 * i, 0, 0],
          [0.9e-3 * i, 1, 0],
          [0.9e-3 * i, 0, i % 2 ? 1 : -1],
        ]).flat(),
        Array.from({ length: count }, (_, i) =>
          i % 2 ? [3 * i, 3 * i + 1, 3 * i + 2] : [3 * i + 1, 3 * i, 3 * i + 2],
        ),
      );
    expect(finish(buildTriangleAdjacency(fins(5), NEAR)).nonManifoldEdges).toBe(1);
    expect(finish(buildTriangleAdjacency(fins(6), NEAR))).toMatchObject({ nonManifoldEdges: 0, borderEdges: 18 });
  });

  const sliver = (side: number) =>
    meshOf(
      [
        [0, 0, 0],
        [side, 0, 0],
        [0, 1, 0],
      ],
      [[0, 1, 2]],
    );

  test('stay apart where a triangle would collapse, unless its side is mere rounding', () => {
    expect(finish(buildTriangleAdjacency(sliver(1e-4), NEAR))).toMatchObject({
      borderEdges: 3,
      degenerateTriangles: 0,
    });
    expect(finish(buildTriangleAdjacency(sliver(1e-7), NEAR))).toMatchObject({
      borderEdges: 0,
      degenerateTriangles: 1,
    });
  });

  test('a soup of torn triangles is joined like the whole surface, in any order', () => {
    const whole = torus(12, 8);
    const count = whole.indices.length / 3;
    const reference = finish(buildTriangleAdjacency(whole));
    fc.assert(
      fc.property(fc.nat(), (seed) => {
        const random = noise(seed);
        const keys = Array.from({ length: 3 * count }, random);
        /** Number of the vertex of each corner. */
        const order = [...keys.keys()].sort((a, b) => keys[a] - keys[b]);
        const numbers: number[] = [];
        const vertices: Row[] = order.map((corner, i) => {
          numbers[corner] = i;
          const from = 3 * whole.indices[corner];
          return [0, 1, 2].map((axis) => whole.positions[from + axis] + 0.45e-3 * random());
        });
        const triangles = Array.from({ length: count }, (_, t) => [0, 1, 2].map((k) => numbers[3 * t + k]));
        const { twins, borderEdges } = finish(buildTriangleAdjacency(meshOf(vertices, triangles), NEAR));
        expect(borderEdges).toBe(0);
        expect(twins).toEqual(reference.twins);
      }),
      { seed: 20080, numRuns: 30 },
    );
  });
});
