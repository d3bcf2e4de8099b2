import { DataUtils } from 'three';
import { describe, expect, test } from 'vitest';
import type { OutlineSurface } from '../../../../src/mesh/bake/bakeOutlines.js';
import { POINT_MASK } from '../../../../src/mesh/bake/outlineLayout.js';
import { packOutlines } from '../../../../src/mesh/bake/packOutlines.js';
import { buffersIn } from '../../../../src/worker/TaskSet.js';
import { finish, meshOf } from '../meshes.js';
import { patch } from '../shapes.js';

const FANS = 5;
/** Fan 4 has no corner. */
const ofCorner = new Uint32Array([0, 1, 2, 2, 1, 3]);
const rows = [
  [0, 0, 0],
  [1, 0, 0.125],
  [0, 1, -3.5],
  [1, 1, 1e-20],
];
const flags = [65, 66, 68, 72, 80, 96, 64, 127];

const surface = (): OutlineSurface => ({
  mesh: meshOf(rows, [
    [0, 1, 2],
    [2, 1, 3],
  ]),
  fans: { ofCorner, count: FANS },
  normals: new Float32Array([0, 0, 1, 0, 0, -1, 0.6, 0, 0.8, 0, -0.6, -0.8, 1, 0, 0]),
  curvatures: Float32Array.from({ length: 6 * FANS }, (_, i) => (i - 12) / 8),
  edges: {
    fans: Uint32Array.from({ length: 4 * flags.length }, (_, i) => i % 4),
    flags: new Uint8Array(flags),
  },
  radius: 3,
  mayCrowd: false,
});

const indices = new Uint32Array([10, 11, 12, 12, 11, 70_000]);
const packed = finish(packOutlines(surface(), indices));

describe('points', () => {
  const floats = new Float32Array(packed.points.buffer);
  const words = (point: number) => packed.points.subarray(8 * point, 8 * point + 8);

  test('have the position, the normal and the vertex of each fan', () => {
    for (const [point, row] of rows.entries()) {
      expect(floats.subarray(8 * point, 8 * point + 3)).toEqual(new Float32Array(row));
    }
    expect(rows.map((_, point) => words(point)[7])).toEqual([10, 11, 12, 70_000]);
    const snorms = Array.from({ length: FANS }, (_, point) => [(words(point)[3] << 16) >> 16, words(point)[3] >> 16]);
    const share = (value: number) => Math.round(0x7fff * value);
    expect(snorms[0]).toEqual([0, 0]);
    expect(snorms[1].map(Math.abs)).toEqual([0x7fff, 0x7fff]);
    expect(snorms[2]).toEqual([share(0.6 / 1.4), 0]);
    expect(snorms[3]).toEqual([share(1 - 0.6 / 1.4), -0x7fff]);
    expect(snorms[4]).toEqual([0x7fff, 0]);
  });

  test('have the curvature times the radius, two halves to a word', () => {
    const { curvatures, radius } = surface();
    for (let point = 0; point < FANS; point++) {
      const halves = [...words(point).subarray(4, 7)].flatMap((word) => [word & 0xffff, word >>> 16]);
      const expected = curvatures.subarray(6 * point, 6 * point + 6);
      expect(halves.map((half) => DataUtils.fromHalfFloat(half))).toEqual([...expected].map((k) => radius * k));
    }
  });

  test('without a corner are allowed', () => {
    expect([...floats.subarray(32, 35)]).toEqual([0, 0, 0]);
    expect(words(4)[7]).toBe(0);
  });
});

describe('primitives', () => {
  test('are all triangles, then all edges', () => {
    expect([packed.triangleCount, packed.edgeCount]).toEqual([2, flags.length]);
    expect([...packed.primitives.subarray(0, 8)]).toEqual([0, 1, 2, 0, 2, 1, 3, 0]);
  });

  test('edges have their points, and their flags in the bits above', () => {
    for (const [edge, flag] of flags.entries()) {
      const [a, b, c, d] = packed.primitives.subarray(8 + 4 * edge, 12 + 4 * edge);
      expect([a & POINT_MASK, b & POINT_MASK, c, d]).toEqual([0, 1, 2, 3]);
      expect((a >>> 28) | ((b >>> 28) << 4)).toBe(flag);
    }
  });
});

test('positions and normals for the search for contours are passed on unchanged', () => {
  expect(packed.normals).toEqual(surface().normals);
  expect(packed.positions.subarray(0, 12)).toEqual(new Float32Array(rows.flat()));
  expect(packed.radius).toBe(3);
});

test('all buffers are transferred', () => {
  const arrays = Object.values(packed).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer] : []));
  expect(arrays).toHaveLength(4);
  expect(new Set(buffersIn(packed))).toEqual(new Set(arrays));
});

test('textures are two texels per point and one per primitive, padded to rows', () => {
  const mesh = patch(40, 40, (u, v) => [u, v, 0]);
  const count = mesh.positions.length / 3;
  const large = finish(
    packOutlines(
      {
        mesh,
        fans: { ofCorner: mesh.indices, count },
        normals: new Float32Array(3 * count),
        curvatures: new Float32Array(6 * count),
        edges: { fans: new Uint32Array(0), flags: new Uint8Array(0) },
        radius: 1,
        mayCrowd: false,
      },
      mesh.indices,
    ),
  );
  const wordsOf = (texels: number) => 4 * 2048 * Math.ceil(texels / 2048);
  expect(large.points).toHaveLength(wordsOf(2 * count));
  expect(large.primitives).toHaveLength(wordsOf(mesh.indices.length / 3));
});
