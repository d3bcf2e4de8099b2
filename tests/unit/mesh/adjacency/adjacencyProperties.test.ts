import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { buildTriangleAdjacency } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, nextCorner, previousCorner } from '../../../../src/mesh/corners.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish, meshOf } from '../meshes.js';

/** Few positions and many triangles, so that seams, duplicates, degenerate triangles and non-manifold edges are frequent. */
const crowdedMesh = fc
  .record({
    vertices: fc.array(fc.tuple(...Array.from({ length: 3 }, () => fc.integer({ min: -1, max: 1 }))), {
      minLength: 4,
      maxLength: 14,
    }),
    seeds: fc.array(fc.tuple(fc.nat(), fc.nat(), fc.nat()), { minLength: 1, maxLength: 40 }),
  })
  .map(({ vertices, seeds }) =>
    meshOf(
      vertices,
      seeds.map((seed) => seed.map((value) => value % vertices.length)),
    ),
  );

/** Triangles on one edge, at any angles: all of them compete for twins. */
const crowdedEdge = fc
  .array(
    fc.tuple(fc.float({ noNaN: true, min: -10, max: 10 }), fc.float({ noNaN: true, min: -10, max: 10 }), fc.boolean()),
    {
      minLength: 3,
      maxLength: 12,
    },
  )
  .map((pages) =>
    meshOf(
      [[0, 0, 0], [1, 2, 3], ...pages.map(([x, y]) => [x, y, x - y + 1])],
      pages.map(([, , isForward], i) => (isForward ? [0, 1, i + 2] : [1, 0, i + 2])),
    ),
  );

const anyMesh = fc.oneof(crowdedMesh, crowdedEdge);

const place = ({ positions, indices }: TriangleMesh, corner: number): string =>
  // + 0 turns −0 into 0
  [...positions.subarray(3 * indices[corner], 3 * indices[corner] + 3)].map((value) => value + 0).join(' ');

const isForward = (mesh: TriangleMesh, corner: number): boolean =>
  place(mesh, corner) < place(mesh, nextCorner(corner));

const edgeOf = (mesh: TriangleMesh, corner: number): string =>
  [place(mesh, corner), place(mesh, nextCorner(corner))].sort().join(' – ');

function unitNormal({ positions, indices }: TriangleMesh, corner: number): number[] {
  const first = corner - (corner % 3);
  const [a, b, c] = [0, 1, 2].map((k) => [...positions.subarray(3 * indices[first + k], 3 * indices[first + k] + 3)]);
  const u = b.map((value, i) => value - a[i]);
  const v = c.map((value, i) => value - a[i]);
  const n = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
  const length = Math.hypot(...n);
  return length === 0 ? [0, 0, 0] : n.map((value) => value / length);
}

const isDegenerate = (mesh: TriangleMesh, corner: number): boolean =>
  unitNormal(mesh, corner).every((value) => value === 0);

const cosine = (mesh: TriangleMesh, a: number, b: number): number => {
  const normal = unitNormal(mesh, b);
  return unitNormal(mesh, a).reduce((sum, value, i) => sum + value * normal[i], 0);
};

/** All half-edges of triangles with area, by undirected edge. */
function halfEdges(mesh: TriangleMesh): Map<string, number[]> {
  const groups = new Map<string, number[]>();
  for (let corner = 0; corner < mesh.indices.length; corner++) {
    if (isDegenerate(mesh, corner)) continue;
    const edge = edgeOf(mesh, corner);
    groups.set(edge, [...(groups.get(edge) ?? []), corner]);
  }
  return groups;
}

/** The neighbours across half-edges in terms of positions: the same for every numbering of the same surface. */
function surfaceOf(mesh: TriangleMesh): string[] {
  const { twins } = finish(buildTriangleAdjacency(mesh));
  const across = [...twins].map((twin, corner) =>
    [
      place(mesh, corner),
      place(mesh, nextCorner(corner)),
      place(mesh, previousCorner(corner)),
      twin === NO_TWIN ? 'border' : place(mesh, previousCorner(twin)),
    ].join(' | '),
  );
  return across.filter((_, corner) => !isDegenerate(mesh, corner)).sort();
}

/** The same examples on every run. */
const examples = { seed: 20080, numRuns: 500 };

describe('triangle adjacency of any mesh', () => {
  test('twin of twin is self, and both have the same two ends', () => {
    fc.assert(
      fc.property(anyMesh, (mesh) => {
        const { twins } = finish(buildTriangleAdjacency(mesh));
        for (const [corner, twin] of twins.entries()) {
          if (twin === NO_TWIN) continue;
          expect(twins[twin]).toBe(corner);
          expect(twin).not.toBe(corner);
          expect(edgeOf(mesh, twin)).toBe(edgeOf(mesh, corner));
        }
      }),
      examples,
    );
  });

  test('counts, borders and pairs equal those of a brute-force grouping of half-edges', () => {
    fc.assert(
      fc.property(anyMesh, (mesh) => {
        const adjacency = finish(buildTriangleAdjacency(mesh));
        const counts = { borderEdges: 0, nonManifoldEdges: 0, unpairedEdges: 0, inconsistentEdges: 0 };
        for (const group of halfEdges(mesh).values()) {
          const forward = group.filter((corner) => isForward(mesh, corner)).length;
          const paired = group.filter((corner) => adjacency.twins[corner] !== NO_TWIN).length;
          if (group.length === 1) counts.borderEdges++;
          else if (group.length > 2) counts.nonManifoldEdges++;
          else if (forward !== 1) counts.inconsistentEdges++;
          if (group.length > 2 && 2 * forward !== group.length) counts.unpairedEdges++;
          expect(paired).toBe(group.length === 2 ? 2 : 2 * Math.min(forward, group.length - forward));
        }
        expect(adjacency).toMatchObject(counts);
        const corners = [...mesh.indices.keys()];
        expect(adjacency.degenerateTriangles).toBe(corners.filter((corner) => isDegenerate(mesh, corner)).length / 3);
      }),
      examples,
    );
  });

  test('on a crowded edge no two half-edges are closer to each other than both are to their twins', () => {
    fc.assert(
      fc.property(anyMesh, (mesh) => {
        const { twins } = finish(buildTriangleAdjacency(mesh));
        for (const group of halfEdges(mesh).values()) {
          if (group.length < 3) continue;
          const closeness = (corner: number) =>
            twins[corner] === NO_TWIN ? -Infinity : cosine(mesh, corner, twins[corner]);
          for (const a of group) {
            for (const b of group) {
              if (isForward(mesh, a) === isForward(mesh, b)) continue;
              expect(cosine(mesh, a, b)).toBeLessThanOrEqual(Math.max(closeness(a), closeness(b)) + 1e-9);
            }
          }
        }
      }),
      examples,
    );
  });

  test('the order of triangles and vertices and the first corner of a triangle do not matter', () => {
    fc.assert(
      fc.property(anyMesh, fc.infiniteStream(fc.nat(1_000_000)), (mesh, random) => {
        const shuffle = <T>(values: T[]): T[] =>
          values
            .map((value) => ({ value, key: random.next().value as number }))
            .sort((a, b) => a.key - b.key)
            .map(({ value }) => value);
        const vertices = Array.from({ length: mesh.positions.length / 3 }, (_, i) => [
          ...mesh.positions.subarray(3 * i, 3 * i + 3),
        ]);
        const order = shuffle([...vertices.keys()]);
        const newNumber = new Map(order.map((old, i) => [old, i]));
        const triangles = Array.from({ length: mesh.indices.length / 3 }, (_, i) => {
          const turn = (random.next().value as number) % 3;
          return [0, 1, 2].map((k) => newNumber.get(mesh.indices[3 * i + ((k + turn) % 3)])!);
        });
        const shuffled = meshOf(
          order.map((old) => vertices[old]),
          shuffle(triangles),
        );
        expect(surfaceOf(shuffled)).toEqual(surfaceOf(mesh));
      }),
      examples,
    );
  });
});
