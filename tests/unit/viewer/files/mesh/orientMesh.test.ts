import { expect, test } from 'vitest';
import { orientMesh } from '../../../../../src/viewer/files/mesh/orientMesh.js';
import type { PlainMesh } from '../../../../../src/viewer/files/mesh/PlainMesh.js';

// A tetrahedron whose triangles face outward.
const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const OUTWARD = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
const outwardNormals = Float32Array.from([-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const reversed = outwardNormals.map((x) => -x);
const mesh = (indices: number[] | null, more: Partial<PlainMesh> = {}): PlainMesh => ({
  positions,
  normals: null,
  colors: null,
  indices: indices && Uint32Array.from(indices),
  ...more,
});
const inside = OUTWARD.map((_, i) => OUTWARD[i - (i % 3) + [0, 2, 1][i % 3]]);

test('a mesh that is right is returned as it is', () => {
  const right = mesh(OUTWARD);
  expect(orientMesh(right)).toEqual({ mesh: right, turned: 0 });
  expect(orientMesh(right).mesh).toBe(right);
});

test('a mesh that is inside out is turned, with normals that point inward', () => {
  const { mesh: found, turned } = orientMesh(mesh(inside, { normals: reversed }));
  expect(turned).toBe(4);
  expect([...found.indices!]).toEqual(OUTWARD);
  expect([...found.normals!]).toEqual([...outwardNormals]);
});

test('normals that point outward already are kept', () => {
  const { mesh: found } = orientMesh(mesh(inside, { normals: outwardNormals }));
  expect([...found.normals!]).toEqual([...outwardNormals]);
});

test('a vertex that a turned and another triangle share becomes two, with all that belongs to it', () => {
  const colors = Float32Array.from({ length: 12 }, (_, i) => i / 12);
  const uvs = Float32Array.from({ length: 8 }, (_, i) => i / 8);
  const mixed = [...OUTWARD.slice(0, 9), ...inside.slice(9)];
  const { mesh: found, turned } = orientMesh(mesh(mixed, { normals: outwardNormals, colors, uvs }));
  expect(turned).toBe(1);
  const shared = [1, 3, 2].map((vertex, k) => [vertex, found.indices![9 + [0, 2, 1][k]]]);
  for (const [vertex, copy] of shared) {
    expect(copy).toBeGreaterThan(3);
    for (const [values, size] of [
      [found.positions, 3],
      [found.colors!, 3],
      [found.uvs!, 2],
    ] as const) {
      expect([...values.slice(size * copy, size * copy + size)]).toEqual([
        ...values.slice(size * vertex, size * vertex + size),
      ]);
    }
  }
  expect([...found.indices!.slice(0, 9)]).toEqual(OUTWARD.slice(0, 9));
});

test('a mesh without an index gets one', () => {
  const corners = Float32Array.from(inside.flatMap((vertex) => [...positions.slice(3 * vertex, 3 * vertex + 3)]));
  const { mesh: found, turned } = orientMesh({ positions: corners, normals: null, colors: null, indices: null });
  expect([turned, found.positions.length, found.indices!.length]).toEqual([4, 36, 12]);
  expect([...found.indices!.slice(0, 3)]).toEqual([0, 2, 1]);
});
