import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import { TorusGeometry } from 'three';
import { beforeAll, expect, test } from 'vitest';
import {
  coarseModel,
  exactPixels,
  isTooFine,
  simplified,
  withoutHeavyPictures,
} from '../../../../src/playground/reading/readLarge.js';
import { clusterMesh } from '../../../../src/viewer/files/mesh/clusterMesh.js';
import type { PlainMesh } from '../../../../src/viewer/files/mesh/PlainMesh.js';
import { isClosed, needsCoarse, plainNormals } from '../../../../src/viewer/files/mesh/plainNormals.js';
import { simplifyMesh } from '../../../../src/viewer/files/mesh/simplifyMesh.js';
import type { ReadMesh } from '../../../../src/viewer/files/readModel.js';
import { scannedTorus } from '../../../../tools/bench/detail/scannedTorus.mjs';
import { distanceFrom } from './distanceFrom.js';

beforeAll(() => MeshoptSimplifier.ready);

/** A cube whose sides bulge to the unit sphere, with `2 · 6 · n²` triangles and the colour of each place. */
function ball(n: number): PlainMesh {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let side = 0; side < 6; side++) {
    const first = positions.length / 3;
    for (let i = 0; i <= n; i++) {
      for (let j = 0; j <= n; j++) {
        const [u, v] = [(2 * i) / n - 1, (2 * j) / n - 1];
        const place = side < 3 ? [u, v, 1] : [v, u, -1];
        const turned = [0, 1, 2].map((axis) => place[(axis + side) % 3] / Math.hypot(u, v, 1));
        positions.push(...turned);
        if (i === n || j === n) continue;
        const a = first + i * (n + 1) + j;
        indices.push(a, a + n + 1, a + n + 2, a, a + n + 2, a + 1);
      }
    }
  }
  return {
    positions: Float32Array.from(positions),
    normals: null,
    colors: Float32Array.from(positions, (value) => (value + 1) / 2),
    indices: Uint32Array.from(indices),
  };
}

const readOf = (mesh: PlainMesh) => ({ kind: 'mesh', mesh, details: [] }) as unknown as ReadMesh;

/** The signed volume, which a hole or a turned triangle would change. */
function volumeOf({ positions, indices }: PlainMesh): number {
  let sum = 0;
  for (let i = 0; i < indices!.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * indices![i + k], 3 * indices![i + k] + 3));
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

/** How far the middle of a triangle lies within the unit sphere at most. */
function deepest({ positions, indices }: PlainMesh): number {
  let depth = 0;
  for (let i = 0; i < indices!.length; i += 3) {
    const middle = [0, 1, 2].map(
      (axis) =>
        (positions[3 * indices![i] + axis] +
          positions[3 * indices![i + 1] + axis] +
          positions[3 * indices![i + 2] + axis]) /
        3,
    );
    depth = Math.max(depth, 1 - Math.hypot(...middle));
  }
  return depth;
}

test('a simplified mesh is within its stated error, keeps its colours and has no unused vertices', () => {
  const mesh = ball(150);
  const progress: number[] = [];
  const { mesh: simple, error } = simplifyMesh(mesh, MeshoptSimplifier, (share) => progress.push(share), 60_000);
  expect(error).toBeLessThan(2 ** -9);
  expect(deepest(simple)).toBeLessThanOrEqual(error);
  expect(simple.indices!.length).toBeLessThanOrEqual(3 * 60_000);
  expect(simple.indices!.length).toBeGreaterThan(3 * 50_000);
  expect(new Set(simple.indices).size).toBe(simple.positions.length / 3);
  expect(volumeOf(simple)).toBeCloseTo(volumeOf(mesh), 2);
  for (let i = 0; i < simple.positions.length; i += 97) {
    expect(simple.colors![i]).toBeCloseTo((simple.positions[i] + 1) / 2, 6);
  }
  expect(progress.length).toBeGreaterThan(10);
  expect(progress.every((share, i) => share >= (progress[i - 1] ?? 0) && share <= 1)).toBe(true);
});

test('no point of a scan is farther from its simplified mesh than the stated error', { tags: ['all'] }, () => {
  const scan = { ...scannedTorus(400), normals: null, colors: null };
  const { mesh, error } = simplifyMesh(scan, MeshoptSimplifier, () => {}, 60_000);
  const distance = distanceFrom(mesh.positions, mesh.indices!);
  let farthest = 0;
  for (let i = 0; i < scan.positions.length; i += 3 * 31) {
    farthest = Math.max(farthest, distance(scan.positions.subarray(i, i + 3)));
  }
  expect(farthest).toBeLessThanOrEqual(error);
  // The bound adds up over all passes: a sixth to a third of it was measured.
  expect(farthest).toBeGreaterThan(0.05 * error);
});

test('a coarse copy has the form, the colours and normals that point outwards', () => {
  const { mesh, plainNormals } = coarseModel(readOf(ball(300)));
  expect(mesh.indices!.length / 3).toBeLessThan(0.5 * 2 * 6 * 300 * 300);
  expect(volumeOf(mesh)).toBeCloseTo(volumeOf(ball(20)), 1);
  const outwards = Math.sign(volumeOf(mesh));
  let [shortest, farthestColor, inwards, sumAlong] = [Infinity, 0, 0, 0];
  for (let i = 0; i < mesh.positions.length; i += 3) {
    shortest = Math.min(shortest, Math.hypot(...mesh.positions.subarray(i, i + 3)));
    farthestColor = Math.max(farthestColor, Math.abs(mesh.colors![i] - (mesh.positions[i] + 1) / 2));
    const along = [0, 1, 2].reduce((sum, k) => sum + mesh.positions[i + k] * plainNormals![i + k], 0);
    if (outwards * along < 0) inwards++;
    sumAlong += outwards * along;
  }
  expect(shortest).toBeGreaterThan(0.97);
  expect(farthestColor).toBeLessThan(1e-4);
  // A triangle may fold over where its corners move to the means of their cells.
  expect(inwards / (mesh.positions.length / 3)).toBeLessThan(0.002);
  expect(sumAlong / (mesh.positions.length / 3)).toBeGreaterThan(0.9);
});

test('a coarse copy of a made model is closed at its seams, which lie on planes through its centre', () => {
  const { attributes, index } = new TorusGeometry(0.7, 0.3, 200, 300);
  const torus = {
    positions: Float32Array.from(attributes.position.array),
    normals: null,
    colors: null,
    indices: Uint32Array.from(index!.array),
  };
  // Both ends of each ring have vertices of their own, and rounding puts one of them on the other side of the plane.
  expect(isClosed(torus)).toBe(false);
  expect(isClosed(clusterMesh(torus))).toBe(true);
});

test('a simplified model states its original triangles and its error', async () => {
  const { mesh, details, simplified: how } = await simplified(readOf(ball(100)), () => {}, 60_000);
  expect(mesh.indices!.length).toBeLessThanOrEqual(3 * 60_000);
  expect(how!.triangles).toBe(120_000);
  expect(how!.error).toBeGreaterThan(0);
  expect(details[0]).toContain(`${exactPixels(how!.error).toLocaleString('en')} pixels`);
});

test('only meshes of more than two million triangles without pictures are simplified', () => {
  const fine = { ...ball(1), indices: new Uint32Array(3 * 2_000_001) };
  expect(isTooFine(readOf(fine))).toBe(true);
  expect(isTooFine(readOf(fine), 3_000_000)).toBe(false);
  expect(isTooFine(readOf({ ...fine, uvs: new Float32Array(2) }))).toBe(false);
  expect(isTooFine(readOf({ ...fine, indices: new Uint32Array(3 * 2_000_000) }))).toBe(false);
});

test('large meshes have a coarse copy as placeholder, and medium ones are their own placeholder', () => {
  const mesh = ball(1);
  const withTriangles = (count: number): PlainMesh => ({ ...mesh, indices: new Uint32Array(3 * count) });
  const [small, medium, large] = [99_000, 400_000, 400_001].map(withTriangles);
  expect([small, medium, large].map(needsCoarse)).toEqual([false, false, true]);
  expect([small, medium, large].map((one) => plainNormals(one) !== null)).toEqual([false, true, false]);
  const pictured = { ...large, ranges: [{ start: 0, count: 3, picture: 0 }] };
  expect([needsCoarse(pictured), plainNormals(pictured)]).toEqual([false, null]);
  expect(coarseModel(readOf(mesh)).plainNormals).toHaveLength(coarseModel(readOf(mesh)).mesh.positions.length);
});

test('pictures are left out, and the caption says so, where there are more triangles than can be drawn with them', () => {
  const pictured = (triangles: number): ReadMesh => ({
    ...readOf({ ...ball(1), indices: new Uint32Array(3 * triangles), uvs: new Float32Array(2), ranges: [] }),
    pictures: [undefined],
    notes: ['a note'],
  });
  const light = pictured(5_000_000);
  expect(withoutHeavyPictures(light)).toBe(light);
  const bare = withoutHeavyPictures(pictured(5_300_000));
  expect(bare.notes).toEqual(['a note', 'too large to be drawn with its pictures']);
  expect(bare).toMatchObject({ pictures: [] });
  expect(isTooFine(bare)).toBe(true);
});

test.each([
  [0.0027, 240],
  [0.0005, 1300],
  [2 / 3 / 999, 990],
])('an error of %f radii is a third of a pixel at most where a model is up to %i pixels across', (error, pixels) => {
  expect(exactPixels(error)).toBe(pixels);
  expect((exactPixels(error) / 2) * error).toBeLessThanOrEqual(1 / 3);
});

test('glass stays glass in simplified models, also without their pictures', async () => {
  const mesh = ball(40);
  const { length } = mesh.indices!;
  const ranges = [
    { start: 0, count: length / 2, picture: 0 },
    { start: length / 2, count: length / 2, picture: -1, isSeeThrough: true },
  ];
  const { mesh: simple } = await simplified(readOf({ ...mesh, ranges }), () => {}, 4000);
  const [solid, glass] = simple.ranges!;
  expect([solid.isSeeThrough, glass.isSeeThrough]).toEqual([undefined, true]);
  expect([solid.start, solid.count, glass.count]).toEqual([0, glass.start, simple.indices!.length - glass.start]);
  expect(simple.indices!.length).toBeLessThan(0.6 * length);
  expect(Math.min(solid.count, glass.count)).toBeGreaterThan(0.3 * simple.indices!.length);
  const heavy = { ...mesh, ranges, uvs: new Float32Array(2), indices: new Uint32Array(3 * 5_300_000) };
  const without = withoutHeavyPictures({ ...readOf(heavy), notes: [] }) as ReadMesh;
  expect(without.mesh.uvs).toBeUndefined();
  expect(without.mesh.ranges?.map(({ picture, isSeeThrough = false }) => [picture, isSeeThrough])).toEqual([
    [-1, false],
    [-1, true],
  ]);
});
