import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { bakeIndexed } from '../../../../src/mesh/bake/bakeIndexed.js';
import type { SurfaceRequest } from '../../../../src/mesh/bake/bakeSurface.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { bakingTasks } from '../../../../src/worker/runTask.js';
import { buffersIn } from '../../../../src/worker/TaskSet.js';
import { finish, meshOf } from '../meshes.js';
import { cube, patch } from '../shapes.js';

const requestFor = (mesh: TriangleMesh, options: Partial<SurfaceRequest> = {}): SurfaceRequest => ({
  label: 'test',
  mesh,
  creaseAngle: Math.PI / 2,
  wantsNormals: false,
  ...options,
});

const bakeOf = (mesh: TriangleMesh, options?: Partial<SurfaceRequest>) =>
  finish(bakeIndexed(requestFor(mesh, options)));

/** A cube whose sides share eight vertices. */
const weldedCube = () => {
  const { positions, indices } = cube(1);
  const names = Array.from({ length: positions.length / 3 }, (_, i) => positions.subarray(3 * i, 3 * i + 3).join(' '));
  const unique = [...new Set(names)];
  return {
    positions: new Float32Array(unique.flatMap((name) => name.split(' ').map(Number))),
    indices: indices.map((vertex) => unique.indexOf(names[vertex])),
  };
};

/**
 *  2 ── 3
 *  │ ╲  │      the right half is folded up about the diagonal by `degrees`
 *  0 ── 1
 */
const foldedQuad = (degrees: number) => {
  const angle = (degrees * Math.PI) / 180;
  const along = 0.5 + 0.5 * Math.cos(angle);
  return meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [along, along, Math.SQRT1_2 * Math.sin(angle)],
    ],
    [
      [0, 1, 2],
      [2, 1, 3],
    ],
  );
};

const up = [0, 0, 32767, 0];

describe('vertices', () => {
  test('stay unchanged on a smooth surface', () => {
    const mesh = foldedQuad(0);
    const { indices, addedVertices, hatchNormals, normals } = bakeOf(mesh);
    expect(indices).toEqual(new Uint16Array(mesh.indices));
    expect([...addedVertices]).toEqual([]);
    expect([...hatchNormals]).toEqual([up, up, up, up].flat());
    expect(normals).toBeNull();
  });

  test('are copied at sharp edges, and only there', () => {
    expect([...bakeOf(foldedQuad(40)).addedVertices]).toEqual([]);
    const { indices, addedVertices, hatchNormals } = bakeOf(foldedQuad(60));
    expect([...addedVertices]).toEqual([2, 1]);
    expect([...indices]).toEqual([0, 1, 2, 4, 5, 3]);
    const normalOf = (vertex: number) => [...hatchNormals.subarray(4 * vertex, 4 * vertex + 4)];
    expect([0, 1, 2].map(normalOf)).toEqual([up, up, up]);
    expect(new Set([3, 4, 5].map((vertex) => normalOf(vertex).join()))).toHaveProperty('size', 1);
    expect(normalOf(3)).not.toEqual(up);
  });

  test('of a cube: eight become twenty-four, and twenty-four stay', () => {
    const eight = bakeOf(weldedCube());
    expect(eight.addedVertices).toHaveLength(16);
    for (const [corner, vertex] of eight.indices.entries()) {
      const normal = [...eight.hatchNormals.subarray(4 * vertex, 4 * vertex + 3)].map((value) => value + 0);
      const triangle = Math.floor(corner / 6);
      expect(normal.map(Math.abs).sort()).toEqual([0, 0, 32767]);
      expect(normal[Math.floor(triangle / 2)]).toBe(triangle % 2 ? -32767 : 32767);
    }
    expect(bakeOf(cube(1)).addedVertices).toHaveLength(0);
    expect(bakeOf(cube(5)).addedVertices).toHaveLength(0);
  });

  test('that no triangle uses, or only a degenerate one, have a normal too', () => {
    const mesh = meshOf(
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [9, 9, 9],
        [5, 5, 5],
      ],
      [
        [3, 3, 0],
        [0, 1, 2],
      ],
    );
    const { hatchNormals, addedVertices, bounds } = bakeOf(mesh);
    expect([...hatchNormals]).toEqual([up, up, up, up, up].flat());
    expect(addedVertices).toHaveLength(0);
    expect(bounds.max).toEqual([9, 9, 9]);
  });

  test('are numbered in 16 bits while the primitive restart index stays free', () => {
    const strip = (vertices: number) => patch(vertices / 2 - 1, 1, (u, v) => [u, v, 0]);
    expect(bakeOf(strip(0xfffe), { smoothingRadius: 0 }).indices).toBeInstanceOf(Uint16Array);
    const large = bakeOf(strip(0x10000), { smoothingRadius: 0 });
    expect(large.indices).toBeInstanceOf(Uint32Array);
    const { indices } = strip(0x10000);
    expect(large.indices.every((vertex, corner) => vertex === indices[corner])).toBe(true);
  });
});

test('smooth normals are added where asked for: split at the crease angle', () => {
  const normals = (creaseAngle: number) => bakeOf(foldedQuad(60), { wantsNormals: true, creaseAngle }).normals!;
  const split = normals(Math.PI / 4);
  expect([...split.subarray(3, 6)]).toEqual([0, 0, 1]);
  const smooth = normals(Math.PI / 2);
  expect(smooth).toHaveLength(3 * 6);
  // Vertex 1 and its copy 5: two hatch normals, one smooth normal.
  expect(smooth.subarray(15, 18)).toEqual(smooth.subarray(3, 6));
  expect(smooth[5]).toBeCloseTo(Math.cos(Math.PI / 6), 6);
});

test('only the mesh and its normals are transferred', () => {
  const request = requestFor(foldedQuad(60), { wantsNormals: true });
  const { positions, indices } = request.mesh;
  expect(bakingTasks.requestBuffers.bakeIndexed(request)).toEqual([positions.buffer, indices.buffer]);
  const result = finish(bakeIndexed(request));
  const buffers = Object.values(result).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer] : []));
  expect(new Set(buffersIn(result))).toEqual(new Set(buffers));
});

test('progress rises and ends at 1', () => {
  const progress = [...bakeIndexed(requestFor(cube(40), { wantsNormals: true }))];
  expect(progress).toEqual(progress.toSorted((a, b) => a - b));
  expect(progress.at(-1)).toBe(1);
  expect(progress.length).toBeGreaterThan(20);
});

test('every corner has the same normal and position as in the corner layout, with as few copies as possible', () => {
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
      fc.constantFrom(undefined, 0, 0.3, 1e30),
      (vertices, seeds, smoothingRadius) => {
        const mesh = meshOf(
          vertices,
          seeds.map((seed) => seed.map((value) => value % vertices.length)),
        );
        const options = { smoothingRadius };
        const corners = finish(bakeCorners({ ...requestFor(mesh, options), attributes: [] }));
        const { indices, addedVertices, hatchNormals, degenerateTriangles } = bakeOf(mesh, options);
        const sourceOf = (vertex: number) =>
          vertex < vertices.length ? vertex : addedVertices[vertex - vertices.length];
        const pairs = new Set<string>();
        for (const [corner, vertex] of indices.entries()) {
          expect(sourceOf(vertex)).toBe(mesh.indices[corner]);
          const normal = hatchNormals.subarray(4 * vertex, 4 * vertex + 4);
          expect(Math.hypot(...normal) / 32767).toBeCloseTo(1, 3);
          if (degenerateTriangles === 0)
            expect(normal).toEqual(corners.hatchNormals.subarray(4 * corner, 4 * corner + 4));
          pairs.add(`${vertex}`);
        }
        for (let corner = 0; corner < indices.length; corner++) {
          expect(Math.hypot(...corners.hatchNormals.subarray(4 * corner, 4 * corner + 4)) / 32767).toBeCloseTo(1, 3);
        }
        // Every copy is used.
        for (let i = 0; i < addedVertices.length; i++) expect(pairs.has(`${vertices.length + i}`)).toBe(true);
      },
    ),
    { seed: 20080, numRuns: 500 },
  );
});
