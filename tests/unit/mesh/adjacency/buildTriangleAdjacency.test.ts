import { describe, expect, test } from 'vitest';
import { buildTriangleAdjacency } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import type { EdgeCounts } from '../../../../src/mesh/adjacency/pairEdges.js';
import { book, byTriangle, fan, finish, meshOf } from '../meshes.js';

const manifold: EdgeCounts = {
  borderEdges: 0,
  nonManifoldEdges: 0,
  unpairedEdges: 0,
  inconsistentEdges: 0,
  degenerateTriangles: 0,
};

const cases: {
  name: string;
  vertices: number[][];
  triangles: number[][];
  /** One row per triangle: the twins of its edges 0, 1, 2; −1 = border. */
  twins: number[][];
  counts: Partial<EdgeCounts>;
}[] = [
  {
    //  2 ── 3
    //  │ ╲  │      corners: 0 1 2 | 3 4 5
    //  0 ── 1
    name: 'two-triangle quad',
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [1, 1, 0],
    ],
    triangles: [
      [0, 1, 2],
      [2, 1, 3],
    ],
    twins: [
      [-1, 3, -1],
      [1, -1, -1],
    ],
    counts: { borderEdges: 4 },
  },
  {
    //      3
    //    ╱ │ ╲
    //   0 ─┼─ 2      seen from outside every triangle is counter-clockwise
    //    ╲ │ ╱
    //      1
    name: 'tetrahedron',
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    triangles: [
      [0, 2, 1],
      [0, 1, 3],
      [1, 2, 3],
      [2, 0, 3],
    ],
    twins: [
      [9, 6, 3],
      [2, 8, 10],
      [1, 11, 4],
      [0, 5, 7],
    ],
    counts: {},
  },
  {
    //   1 ── 3 ── 5
    //   │ ╲  │ ╲  │
    //   0 ── 2 ── 4
    name: 'open strip',
    vertices: [
      [0, 0, 0],
      [0, 1, 0],
      [1, 0, 0],
      [1, 1, 0],
      [2, 0, 0],
      [2, 1, 0],
    ],
    triangles: [
      [0, 2, 1],
      [2, 3, 1],
      [2, 4, 3],
      [4, 5, 3],
    ],
    twins: [
      [-1, 5, -1],
      [8, -1, 1],
      [-1, 11, 3],
      [-1, -1, 7],
    ],
    counts: { borderEdges: 6 },
  },
  {
    //   0 ── 2 ── 4 ── 1'
    //    ╲  ╱ ╲  ╱ ╲  ╱ ╲       five triangles in a row; its right end 1'–0' is its left end 0–1 turned over,
    //     1 ── 3 ── 0 ── …      so one edge is passed twice in the same direction wherever it is cut
    name: 'Moebius strip',
    vertices: [
      [2, 0, 0],
      [1, 2, 1],
      [-1, 1, 2],
      [-2, -1, 1],
      [0, -2, -1],
    ],
    triangles: [
      [0, 1, 2],
      [2, 1, 3],
      [2, 3, 4],
      [4, 3, 0],
      [4, 0, 1],
    ],
    twins: [
      [13, 3, -1],
      [1, -1, 6],
      [5, 9, -1],
      [7, -1, 12],
      [11, 0, -1],
    ],
    counts: { borderEdges: 5, inconsistentEdges: 1 },
  },
  {
    //        4              seen along the edge 0–1 (a dot):
    //        │
    //   2 ── · ── 3         triangles 0 and 1 lie in one plane, triangle 2 stands on it.
    //                       0 runs 0→1; 1 and 2 run 1→0. The plane's normals are equal, so 0 and 1 are twins.
    name: 'three triangles on one edge',
    vertices: [
      [0, 0, 0],
      [0, 0, 1],
      [-1, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
    triangles: [
      [0, 1, 2],
      [1, 0, 3],
      [1, 0, 4],
    ],
    twins: [
      [3, -1, -1],
      [0, -1, -1],
      [-1, -1, -1],
    ],
    counts: { borderEdges: 6, nonManifoldEdges: 1, unpairedEdges: 1 },
  },
  {
    //  2 ── 3
    //  │ ╲  │      the right triangle is clockwise: both run 1→2
    //  0 ── 1
    name: 'inconsistent winding',
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [1, 1, 0],
    ],
    triangles: [
      [0, 1, 2],
      [1, 2, 3],
    ],
    twins: [
      [-1, 3, -1],
      [1, -1, -1],
    ],
    counts: { borderEdges: 4, inconsistentEdges: 1 },
  },
  {
    //   3 ─────── 2
    //   │ ╲       │
    //   │    ╲    │     the edge 0–1 above meets the edges 0–5 and 5–1 below: no ends in common, so no twins
    //   0 ── 5 ── 1
    //    ╲   │   ╱
    //        4
    name: 'T-junction',
    vertices: [
      [0, 0, 0],
      [2, 0, 0],
      [2, 2, 0],
      [0, 2, 0],
      [1, -1, 0],
      [1, 0, 0],
    ],
    triangles: [
      [0, 1, 3],
      [1, 2, 3],
      [0, 4, 5],
      [4, 1, 5],
    ],
    twins: [
      [-1, 5, -1],
      [-1, -1, 1],
      [-1, 11, -1],
      [-1, -1, 7],
    ],
    counts: { borderEdges: 8 },
  },
  {
    //   2
    //   │ ╲          twice the same triangle: nothing else is there, so each edge has two half-edges of one direction
    //   0 ── 1
    name: 'duplicate triangle',
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
    triangles: [
      [0, 1, 2],
      [0, 1, 2],
    ],
    twins: [
      [3, 4, 5],
      [0, 1, 2],
    ],
    counts: { inconsistentEdges: 3 },
  },
  {
    //   2 ─ 4 ─ 3        triangle 1 (2, 4, 3) has no area, triangle 2 has a corner twice; triangle 0 stays alone
    //     ╲   ╱
    //       0
    name: 'degenerate triangles',
    vertices: [
      [1, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [2, 1, 0],
      [1, 1, 0],
    ],
    triangles: [
      [0, 3, 2],
      [2, 4, 3],
      [0, 1, 2],
    ],
    twins: [
      [-1, -1, -1],
      [-1, -1, -1],
      [-1, -1, -1],
    ],
    counts: { borderEdges: 3, degenerateTriangles: 2 },
  },
  {
    //   2 ── 3       the quad again, its two halves not sharing a vertex; 1' has −0 where 1 has 0
    //   │ ╲  │
    //   0 ── 1
    name: 'seam, welded by position',
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [-0, 1, -0],
      [1, -0, 0],
      [1, 1, 0],
    ],
    triangles: [
      [0, 1, 2],
      [3, 4, 5],
    ],
    twins: [
      [-1, 3, -1],
      [1, -1, -1],
    ],
    counts: { borderEdges: 4 },
  },
];

describe('buildTriangleAdjacency', () => {
  test.each(cases)('$name', ({ vertices, triangles, twins, counts }) => {
    const adjacency = finish(buildTriangleAdjacency(meshOf(vertices, triangles)));
    expect(byTriangle(adjacency.twins)).toEqual(twins);
    expect(adjacency).toMatchObject({ ...manifold, ...counts });
  });

  test('uv-seam cube: four vertices per side, sides joined where they meet', () => {
    //    3 ── 2       a side seen from outside, and its triangles 0 1 3 and 1 2 3;
    //    │ ╲  │       the signs of x, y, z of its vertices 0 1 2 3, and what lies below, left, right, above
    //    0 ── 1
    const sides: Record<string, { corners: string; below: string; left: string; right: string; above: string }> = {
      front: { corners: '--+ +-+ +++ -++', below: 'bottom', left: 'left', right: 'right', above: 'top' },
      back: { corners: '+-- --- -+- ++-', below: 'bottom', left: 'right', right: 'left', above: 'top' },
      left: { corners: '--- --+ -++ -+-', below: 'bottom', left: 'back', right: 'front', above: 'top' },
      right: { corners: '+-+ +-- ++- +++', below: 'bottom', left: 'front', right: 'back', above: 'top' },
      top: { corners: '-++ +++ ++- -+-', below: 'front', left: 'left', right: 'right', above: 'back' },
      bottom: { corners: '--- +-- +-+ --+', below: 'back', left: 'left', right: 'right', above: 'front' },
    };
    const names = Object.keys(sides);
    const vertices = Object.values(sides).flatMap(({ corners }) =>
      corners.split(' ').map((signs) => [...signs].map((sign) => (sign === '+' ? 0.5 : -0.5))),
    );
    const triangles = names.flatMap((_, i) => [
      [4 * i, 4 * i + 1, 4 * i + 3],
      [4 * i + 1, 4 * i + 2, 4 * i + 3],
    ]);
    const adjacency = finish(buildTriangleAdjacency(meshOf(vertices, triangles)));
    expect(adjacency).toMatchObject(manifold);
    const sideAcross = byTriangle(adjacency.twins).map((row) => row.map((twin) => names[Math.floor(twin / 6)]));
    expect(sideAcross).toEqual(
      Object.entries(sides).flatMap(([name, { below, left, right, above }]) => [
        [below, name, left],
        [right, above, name],
      ]),
    );
  });

  test('a fan of 100,000 triangles around one vertex takes linear time', () => {
    const small = finish(buildTriangleAdjacency(fan(1_000)));
    const large = finish(buildTriangleAdjacency(fan(100_000)));
    expect(large).toMatchObject({ ...manifold, borderEdges: 100_000 });
    expect(large.steps).toBeLessThan(10 * 100_000);
    expect(large.steps / small.steps).toBeLessThan(110);
  });

  test('a book of 100,000 triangles on one edge takes n log n', () => {
    const large = finish(buildTriangleAdjacency(book(100_000)));
    expect(large.nonManifoldEdges).toBe(1);
    expect(large.twins.filter((twin) => twin >= 0)).toHaveLength(100_000);
    expect(large.steps).toBeLessThan(100_000 * 10 * Math.log2(100_000));
  });

  test('progress rises from 0 to 1', () => {
    const progress = [...buildTriangleAdjacency(fan(50_000))];
    expect(progress.length).toBeGreaterThan(20);
    for (let i = 1; i < progress.length; i++) expect(progress[i]).toBeGreaterThanOrEqual(progress[i - 1]);
    expect(progress.at(-1)).toBe(1);
  });
});

test('a mesh without duplicate positions uses its indices as canonical corners', () => {
  const mesh = fan(5);
  expect(finish(buildTriangleAdjacency(mesh)).canonicalCorners).toBe(mesh.indices);
});
