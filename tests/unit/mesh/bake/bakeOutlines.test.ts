import { isDeepStrictEqual } from 'node:util';
import fc from 'fast-check';
import { DataUtils, IcosahedronGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { type BakeRequest, bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { bakeIndexed } from '../../../../src/mesh/bake/bakeIndexed.js';
import { bakePull } from '../../../../src/mesh/bake/bakePull.js';
import type { BakeReport } from '../../../../src/mesh/bake/bakeSurface.js';
import { BORDER, CREASE, POINT_MASK } from '../../../../src/mesh/bake/outlineLayout.js';
import type { PackedOutlines } from '../../../../src/mesh/bake/packOutlines.js';
import { computeAreaNormals } from '../../../../src/mesh/computeAreaNormals.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { buffersIn } from '../../../../src/worker/TaskSet.js';
import { meshFrom, outlinesOf } from '../features/surfaces.js';
import { finish, meshOf } from '../meshes.js';
import { cube, patch, together, torus } from '../shapes.js';

const requestFor = (mesh: TriangleMesh, options: Partial<BakeRequest> = {}): BakeRequest => ({
  label: 'test',
  mesh: { positions: mesh.positions.slice(), indices: mesh.indices.slice() },
  creaseAngle: Math.PI / 2,
  wantsNormals: true,
  attributes: [{ words: new Uint16Array(mesh.positions.length / 3).map((_, i) => i), wordsPerVertex: 1 }],
  ...options,
});

const outlines = { triangleGroups: null };

const meshes: [string, TriangleMesh][] = [
  ['a cube of six sides', cube(2)],
  ['a pleated patch with a border', patch(8, 5, (u, v) => [u, v, Math.round(8 * u) % 2])],
  ['a torus', torus(30, 16)],
  ['a coarse sphere', meshFrom(new IcosahedronGeometry(1, 2))],
];

/** The flags of each edge. */
const flagsOf = ({ primitives, triangleCount, edgeCount }: PackedOutlines): number[] =>
  Array.from({ length: edgeCount }, (_, edge) => {
    const i = 4 * (triangleCount + edge);
    return (primitives[i] >>> 28) | ((primitives[i + 1] >>> 28) << 4);
  });

describe.each(meshes)('%s', (_, mesh) => {
  test('outlines do not change the other bytes of a bake', () => {
    for (const task of [bakeCorners, bakeIndexed, bakePull]) {
      const run = (options: Partial<BakeRequest>) =>
        finish<{ outlines: PackedOutlines | null }>(task(requestFor(mesh, options)));
      const without = run({});
      expect(without.outlines).toBeNull();
      expect(isDeepStrictEqual(run({ outlines: null }), without)).toBe(true);
      const drawn = run({ outlines });
      expect(drawn.outlines).not.toBeNull();
      for (const [name, value] of Object.entries({ ...drawn, outlines: null })) {
        expect([name, isDeepStrictEqual(value, Reflect.get(without, name))]).toEqual([name, true]);
      }
      expect(Object.keys(drawn).sort()).toEqual(Object.keys(without).sort());
    }
  });

  test('transfers the outlines with every layout, each buffer once', () => {
    const request = requestFor(mesh, { outlines });
    for (const result of [bakeCorners, bakeIndexed, bakePull].map((bake) => finish<BakeReport>(bake(request)))) {
      const buffers = buffersIn(result);
      expect(new Set(buffers).size).toBe(buffers.length);
      for (const value of Object.values(result.outlines!)) {
        if (ArrayBuffer.isView(value)) expect(buffers).toContain(value.buffer);
      }
      expect(buffers).toHaveLength(buffersIn({ ...result, outlines: null }).length + 4);
    }
  });

  test('has the same outlines in every layout, with the vertices of that layout', () => {
    const request = requestFor(mesh, { outlines });
    const corner = finish(bakeCorners(request)).outlines!;
    const indexed = finish(bakeIndexed(request));
    const pull = finish(bakePull(request));
    const withoutVertices = (packed: PackedOutlines) => ({
      ...packed,
      points: packed.points.map((w, i) => (i % 8 === 7 ? 0 : w)),
    });
    for (const other of [indexed.outlines!, pull.outlines!]) {
      expect(isDeepStrictEqual(withoutVertices(other), withoutVertices(corner))).toBe(true);
    }
    for (let i = 0; i < mesh.indices.length; i++) {
      const point = corner.primitives[4 * Math.floor(i / 3) + (i % 3)];
      const at = [...corner.positions.subarray(3 * point, 3 * point + 3)];
      expect(at).toEqual([...mesh.positions.subarray(3 * mesh.indices[i], 3 * mesh.indices[i] + 3)]);
      // The vertex of the point is one at its place.
      const vertex = pull.outlines!.points[8 * point + 7];
      expect([...pull.vertexPositions.subarray(4 * vertex, 4 * vertex + 3)]).toEqual(at);
    }
    const vertexCount = mesh.positions.length / 3;
    for (let point = 0; point < indexed.outlines!.positions.length / 3; point++) {
      const vertex = indexed.outlines!.points[8 * point + 7];
      const source = vertex < vertexCount ? vertex : indexed.addedVertices[vertex - vertexCount];
      expect(mesh.positions.slice(3 * source, 3 * source + 3)).toEqual(
        indexed.outlines!.positions.slice(3 * point, 3 * point + 3),
      );
    }
  });

  test('reports a progress that rises and ends at 1', () => {
    const progress = [...bakeCorners(requestFor(mesh, { outlines }))];
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
  });
});

test('outline normals are unit normals of the shape, one on each side of a sharp edge', () => {
  const box = finish(bakeCorners(requestFor(cube(2), { outlines }))).outlines!;
  expect(box.triangleCount).toBe(48);
  for (let i = 0; i < box.normals.length; i += 3) {
    expect([...box.normals.subarray(i, i + 3)].map(Math.abs).sort()).toEqual([0, 0, 1]);
  }
  const ring = outlinesOf(torus(60, 30));
  expect(ring.edges.flags).toHaveLength(0);
  for (let i = 0; i < ring.normals.length; i += 3) {
    expect(Math.hypot(...ring.normals.subarray(i, i + 3))).toBeCloseTo(1, 6);
  }
});

test('triangles of a coarse mesh keep their own normals, and have no curvature', () => {
  const { fans, normals, curvatures, mesh } = outlinesOf(meshFrom(new IcosahedronGeometry(1, 2)));
  expect(fans.count).toBe(mesh.indices.length);
  expect(curvatures.every((value) => value === 0)).toBe(true);
  for (let i = 0; i < normals.length; i += 9) {
    expect(normals.slice(i + 3, i + 6)).toEqual(normals.slice(i, i + 3));
    expect(normals.slice(i + 6, i + 9)).toEqual(normals.slice(i, i + 3));
  }
});

test('creases are drawn from a fifth of the bounding radius on, or from the given length', () => {
  // A tent on a large plane, whose ridge of 60° is `length` long.
  const tent = (length: number) =>
    meshOf(
      [
        [0, 0, 0],
        [length, 0, 0],
        [0, 1, 0],
        [length, 1, 0],
        [0, -0.5, -0.866],
        [length, -0.5, -0.866],
        [0, 1, 20],
        [0.01, 1, 20],
      ],
      [
        [0, 1, 3],
        [0, 3, 2],
        [1, 0, 4],
        [1, 4, 5],
        [2, 6, 7],
      ],
    );
  const creases = (length: number, options = {}) => {
    const found = finish(bakeCorners(requestFor(tent(length), { outlines: { ...outlines, ...options } }))).outlines!;
    return flagsOf(found).filter((flags) => flags & CREASE).length;
  };
  // The radius is about 10.5.
  expect(creases(1.9)).toBe(0);
  expect(creases(2.4)).toBe(1);
  expect(creases(1.9, { creaseLength: 1.8 })).toBe(1);
  expect(creases(1.9, { creaseLength: 0 })).toBe(1);
  expect(creases(2.4, { featureAngle: 1.1 })).toBe(0);
  expect(creases(2.4, { featureAngle: 1 })).toBe(1);
});

test('specks of a scan take the normals of the surface below them, in outlines only', () => {
  const flat = patch(60, 60, (u, v) => [u, v, 0]);
  const fold = meshOf(
    [
      [0.5, 0.5, 0],
      [0.5 + 1 / 60, 0.5, 0],
      [0.5, 0.5, 0.01],
    ],
    [[0, 1, 2]],
  );
  const scan = together(flat, fold);
  const tilted = ({ fans, normals, mesh }: ReturnType<typeof outlinesOf>) =>
    [...fans.ofCorner.subarray(mesh.indices.length - 3)].map((fan) => normals[3 * fan + 2] < 0.99);
  // The tip, which only the fold has, is turned as a flap.
  expect(tilted(outlinesOf(scan, { smoothingRadius: 0 }))).toEqual([false, false, false]);
  // Of few triangles, it is a face.
  const few = together(
    patch(4, 4, (u, v) => [u, v, 0]),
    fold,
  );
  expect(tilted(outlinesOf(few, { smoothingRadius: 0 }))).toEqual([true, true, true]);
  const hatchNormals = (options: Partial<BakeRequest>) =>
    finish(bakeCorners(requestFor(scan, { smoothingRadius: 0, ...options }))).hatchNormals;
  expect(isDeepStrictEqual(hatchNormals({ outlines }), hatchNormals({}))).toBe(true);
});

test('narrow sides of boxes keep their normals, even if a mesh has many', () => {
  const boxes = together(
    torus(60, 30),
    ...Array.from({ length: 500 }, (_, i) => {
      const { positions, indices } = cube(1);
      const corner = [3 * (i % 25), 3 * Math.floor(i / 25), 9];
      return { positions: positions.map((value, j) => corner[j % 3] + value * [1, 1, 0.1][j % 3]), indices };
    }),
  );
  const { fans, normals, mesh } = outlinesOf(boxes, { smoothingRadius: 0 });
  const areaNormals = finish(computeAreaNormals(mesh));
  const turned = [...fans.ofCorner.keys()].slice(60 * 30 * 6).filter((corner) => {
    const [fan, triangle] = [3 * fans.ofCorner[corner], 3 * Math.floor(corner / 3)];
    const dot = [0, 1, 2].reduce((sum, i) => sum + normals[fan + i] * areaNormals[triangle + i], 0);
    return dot < 0.99 * Math.hypot(...areaNormals.subarray(triangle, triangle + 3));
  });
  expect(turned).toEqual([]);
});

test('the crease angle of the adjacency adds no borders to the outlines', () => {
  const found = finish(bakeCorners(requestFor(cube(2), { creaseAngle: 0, outlines }))).outlines!;
  expect(flagsOf(found).filter((flags) => flags & BORDER)).toEqual([]);
  expect(flagsOf(found).filter((flags) => flags & CREASE)).toHaveLength(24);
});

test('outlines have no NaN, and their points lie at the positions of their corners', () => {
  const coordinate = fc.constantFrom(0, -0, 1, -1, 0.5, 1e-30, 1e-45, 3.4e38, -3.4e38);
  const small = fc.integer({ min: -1, max: 1 });
  const vertex = fc.oneof(
    { weight: 4, arbitrary: fc.tuple(small, small, small) },
    fc.tuple(coordinate, coordinate, coordinate),
  );
  fc.assert(
    fc.property(
      fc.array(vertex, { minLength: 3, maxLength: 14 }),
      fc.array(fc.tuple(fc.nat(), fc.nat(), fc.nat()), { minLength: 1, maxLength: 40 }),
      fc.constantFrom(undefined, 0, 1),
      (vertices, seeds, creaseAngle) => {
        const mesh = meshOf(
          vertices,
          seeds.map((seed) => seed.map((value) => value % vertices.length)),
        );
        const surface = outlinesOf(mesh, { outlines: { triangleGroups: null, featureAngle: creaseAngle } });
        expect(surface.normals.every(Number.isFinite)).toBe(true);
        expect(surface.curvatures.some(Number.isNaN)).toBe(false);
        const { points, primitives, positions, triangleCount, edgeCount } = finish(
          bakeCorners(requestFor(mesh, { outlines: { ...outlines, featureAngle: creaseAngle } })),
        ).outlines!;
        const count = positions.length / 3;
        for (let point = 0; point < count; point++) {
          for (const word of points.subarray(8 * point + 4, 8 * point + 7)) {
            expect(DataUtils.fromHalfFloat(word & 0xffff)).not.toBeNaN();
            expect(DataUtils.fromHalfFloat(word >>> 16)).not.toBeNaN();
          }
        }
        for (let i = 4 * triangleCount; i < 4 * (triangleCount + edgeCount); i++) {
          expect(primitives[i] & POINT_MASK).toBeLessThan(count);
        }
      },
    ),
    { seed: 20080, numRuns: 200 },
  );
});
