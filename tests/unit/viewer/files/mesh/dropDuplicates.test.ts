import { expect, test } from 'vitest';
import { dropDuplicates } from '../../../../../src/viewer/files/mesh/dropDuplicates.js';
import type { PlainMesh } from '../../../../../src/viewer/files/mesh/PlainMesh.js';
import { Random } from '../../../../../src/viewer/settings/Random.js';

const mesh = (positions: number[], more: Partial<PlainMesh> = {}): PlainMesh => ({
  positions: Float32Array.from(positions),
  normals: null,
  colors: null,
  indices: null,
  ...more,
});
const A = [0, 0, 0];
const B = [1, 0, 0];
const C = [0, 1, 0];
const D = [0, 0, 1];

test('one of several triangles with the same corners and winding is kept', () => {
  const { mesh: left, duplicates } = dropDuplicates(mesh([A, B, C, B, C, A, C, A, B, A, B, D].flat()));
  expect(duplicates).toBe(2);
  const corners = [...left.indices!].map((vertex) =>
    [A, B, C, D].findIndex((place) => place.join() === left.positions.subarray(3 * vertex, 3 * vertex + 3).join()),
  );
  expect(corners).toHaveLength(6);
  // Its sense is kept, whichever corner comes first.
  const [first, second, third] = corners;
  expect([second, third]).toEqual([(first + 1) % 3, (first + 2) % 3]);
});

test('a triangle with the opposite winding is another one', () => {
  const twoSided = mesh([A, B, C, A, C, B].flat());
  expect(dropDuplicates(twoSided)).toEqual({ mesh: twoSided, duplicates: 0 });
});

test('where surfaces have no sides the back of a sheet is a duplicate, whichever corner it begins with', () => {
  for (const back of [
    [A, C, B, B, C, D],
    [C, B, A, C, D, B],
    [B, A, C, D, B, C],
  ]) {
    const sheet = mesh([A, B, C, B, D, C, ...back].flat());
    const { mesh: left, duplicates } = dropDuplicates(sheet, false);
    expect(duplicates).toBe(2);
    expect(left.indices).toHaveLength(6);
    expect(dropDuplicates(sheet)).toEqual({ mesh: sheet, duplicates: 0 });
  }
});

test('flaps that stand alone keep both sides, which close a surface, but no copies of one', () => {
  const flaps = Array.from({ length: 20 }, (_, i) => {
    const [one, other, tip] = [A, B, C].map(([x, y, z]) => [x + 3 * i, y, z]);
    return [one, other, tip, one, tip, other, tip, other, one];
  });
  const scan = mesh(flaps.flat(2));
  expect(dropDuplicates(scan, false)).toEqual(dropDuplicates(scan));
  expect(dropDuplicates(scan).duplicates).toBe(20);
});

test('triangles that differ in colours, texture coordinates or pictures are kept', () => {
  const positions = [A, B, C, A, B, C].flat();
  const colors = Float32Array.from({ length: 18 }, (_, i) => (i === 17 ? 0.5 : 1));
  expect(dropDuplicates(mesh(positions, { colors })).duplicates).toBe(0);
  expect(dropDuplicates(mesh(positions, { colors: colors.fill(1) })).duplicates).toBe(1);
  const uvs = Float32Array.from({ length: 12 }, (_, i) => (i === 0 ? 0.5 : 1));
  expect(dropDuplicates(mesh(positions, { uvs })).duplicates).toBe(0);
  const ranges = [
    { start: 0, count: 3, picture: 0 },
    { start: 3, count: 3, picture: 1 },
  ];
  expect(dropDuplicates(mesh(positions, { ranges })).duplicates).toBe(0);
});

test('ranges are shortened', () => {
  const ranges = [
    { start: 0, count: 6, picture: 0 },
    { start: 6, count: 3, picture: 1 },
  ];
  const { mesh: left } = dropDuplicates(mesh([A, B, C, A, B, C, A, B, D].flat(), { ranges }));
  expect(left.ranges).toEqual([
    { start: 0, count: 3, picture: 0 },
    { start: 3, count: 3, picture: 1 },
  ]);
  expect(left.indices).toHaveLength(6);
});

test('missing corners and corners that are not numbers are left to others', () => {
  const broken = mesh([A, B, [Number.NaN, 0, 0]].flat(), {
    indices: Uint32Array.of(0, 1, 9, 0, 1, 9, 0, 1, 2, 0, 1, 8),
  });
  expect(dropDuplicates(broken).duplicates).toBe(1);
});

test('as many as a slow comparison finds', () => {
  const random = new Random(7);
  const indices = Uint32Array.from({ length: 3000 }, () => random.below(8));
  const positions = Array.from({ length: 24 }, (_, i) => (i % 3) * Math.floor(i / 6));
  const seen = new Set<string>();
  for (let t = 0; t < 3000; t += 3) {
    const corners = [...indices.subarray(t, t + 3)].map((vertex) => positions.slice(3 * vertex, 3 * vertex + 3).join());
    seen.add([0, 1, 2].map((k) => [...corners.slice(k), ...corners.slice(0, k)].join(' ')).sort()[0]);
  }
  expect(dropDuplicates(mesh(positions, { indices })).mesh.indices!.length / 3).toBe(seen.size);
});

test('a few duplicates, as scans have, stay: the mesh is as it was', () => {
  const positions = Float32Array.from({ length: 9 * 60 }, (_, i) => Math.sin(7 * i));
  const indices = Uint32Array.from([...Array(180).keys(), 0, 1, 2]);
  const mesh = { positions, normals: null, colors: null, indices };
  expect(dropDuplicates(mesh)).toEqual({ mesh, duplicates: 0 });
  // More would be drawn with lines at every edge, as where surfaces end.
  const more = { ...mesh, indices: Uint32Array.from([...indices, ...indices.subarray(3, 15)]) };
  expect(dropDuplicates(more).duplicates).toBe(5);
});

test('duplicates are found in large meshes too, whether spread or copies of one triangle', () => {
  const random = new Random(3);
  const distinct = Float32Array.from({ length: 9 * 90_000 }, () => random.next());
  const withCopies = (count: number, from: (i: number) => number): PlainMesh => {
    const positions = new Float32Array(distinct.length + 9 * count);
    positions.set(distinct);
    for (let i = 0; i < count; i++) {
      positions.set(distinct.subarray(9 * from(i), 9 * from(i) + 9), distinct.length + 9 * i);
    }
    return mesh([], { positions });
  };
  expect(dropDuplicates(withCopies(15_000, (i) => i)).duplicates).toBe(15_000);
  for (let one = 0; one < 8; one++) expect(dropDuplicates(withCopies(15_000, () => one)).duplicates).toBe(15_000);
  expect(dropDuplicates(withCopies(3_000, (i) => i % 300)).duplicates).toBe(3_000);
  // Few are harmless.
  expect(dropDuplicates(withCopies(500, (i) => i)).duplicates).toBe(0);
});
