import { describe, expect, test } from 'vitest';
import { CORNER_STRIDE } from '../../../../src/mesh/bake/attributeLayouts.js';
import { type BakeRequest, bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { bakePull } from '../../../../src/mesh/bake/bakePull.js';
import { pullTextureSize } from '../../../../src/mesh/bake/pullLayout.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { bakingTasks } from '../../../../src/worker/runTask.js';
import { buffersIn } from '../../../../src/worker/TaskSet.js';
import { finish } from '../meshes.js';
import { cube, patch } from '../shapes.js';

const requestFor = (mesh: TriangleMesh, options: Partial<BakeRequest> = {}): BakeRequest => ({
  label: 'test',
  mesh: { positions: mesh.positions.slice(), indices: mesh.indices.slice() },
  creaseAngle: Math.PI / 2,
  wantsNormals: false,
  attributes: [{ words: new Uint16Array(mesh.positions.length / 3).map((_, i) => i), wordsPerVertex: 1 }],
  ...options,
});

const meshes: [string, TriangleMesh][] = [
  ['a cube of six sides', cube(1)],
  // Folds sharper than the crease angle, through vertices that both sides share.
  ['a pleated patch with a border', patch(8, 5, (u, v) => [u, v, Math.round(8 * u) % 2])],
];

describe.each(meshes)('%s', (_, mesh) => {
  const corners = mesh.indices.length;

  test.each([false, true])(
    'finds the vertices whose positions the corner layout has (normals added: %s)',
    (wantsNormals) => {
      const corner = finish(bakeCorners(requestFor(mesh, { wantsNormals })));
      const pull = finish(bakePull(requestFor(mesh, { wantsNormals })));
      const { triangleVertices: words, vertexPositions } = pull;
      const positionOf = (vertex: number) => [...vertexPositions.subarray(4 * vertex, 4 * vertex + 3)];
      for (let i = 0; i < corners; i++) {
        const triangle = 8 * Math.floor(i / 3);
        expect(positionOf(words[triangle + (i % 3)])).toEqual([...corner.positions.subarray(3 * i, 3 * i + 3)]);
        const opposite = [0, 1, 2].flatMap((k) => positionOf(words[triangle + 4 + k]));
        expect(opposite).toEqual([...corner.corners.subarray(CORNER_STRIDE * i + 7, CORNER_STRIDE * i + 16)]);
      }
      expect(pull.positions).toEqual(corner.positions);
      expect(pull.hatchNormals).toEqual(corner.hatchNormals);
      expect(pull.normals).toEqual(corner.normals);
      expect(pull.attributes).toEqual(corner.attributes);
    },
  );

  test.each([false, true])('marks one corner of each vertex, of one normal (normals added: %s)', (wantsNormals) => {
    const { triangleVertices: words, normals } = finish(bakePull(requestFor(mesh, { wantsNormals })));
    const writers = new Map<number, number>();
    for (let i = 0; i < corners; i++) {
      const triangle = 8 * Math.floor(i / 3);
      const vertex = words[triangle + (i % 3)];
      if ((words[triangle + 3] >> (i % 3)) & 1) {
        expect(writers.has(vertex)).toBe(false);
        writers.set(vertex, i);
      }
      const writer = writers.get(vertex)!;
      if (normals) expect(normals.slice(3 * i, 3 * i + 3)).toEqual(normals.slice(3 * writer, 3 * writer + 3));
    }
  });
});

test('textures are two texels per triangle and one per vertex, padded to rows', () => {
  const mesh = patch(60, 50, (u, v) => [u, v, 0]);
  const { triangleVertices, vertexPositions } = finish(bakePull(requestFor(mesh)));
  const rows = (texels: number) => 4 * 2048 * Math.ceil(texels / 2048);
  expect(triangleVertices.length).toBe(rows((2 * mesh.indices.length) / 3));
  expect(vertexPositions.length).toBe(rows(mesh.positions.length / 3));
  expect(pullTextureSize(12)).toEqual({ width: 12, height: 1 });
  expect(pullTextureSize(2049)).toEqual({ width: 2048, height: 2 });
  // Ten million triangles: wider, so that no device has too few rows.
  expect(pullTextureSize(20_000_000)).toEqual({ width: 8192, height: 2442 });
});

test('all buffers are transferred, each once', () => {
  const request = requestFor(cube(1), { wantsNormals: true });
  expect(bakingTasks.requestBuffers.bakePull(request)).toHaveLength(3);
  expect(buffersIn(finish(bakePull(request)))).toHaveLength(6);
});
