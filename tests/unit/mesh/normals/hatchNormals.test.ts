import { describe, expect, test } from 'vitest';
import { bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import { bakeIndexed } from '../../../../src/mesh/bake/bakeIndexed.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { fan, finish, meshOf } from '../meshes.js';
import { cube, noise, patch, prism, sphere, together, torus } from '../shapes.js';

const DEGREES = Math.PI / 180;

/** The hatch normal of each corner, with its position. */
function cornersOf(mesh: TriangleMesh, smoothingRadius?: number) {
  const request = { label: 'test', mesh, creaseAngle: Math.PI / 2, smoothingRadius, wantsNormals: false };
  const { positions, hatchNormals } = finish(bakeCorners({ ...request, attributes: [] }));
  return Array.from(mesh.indices, (_, corner) => ({
    position: [...positions.subarray(3 * corner, 3 * corner + 3)],
    normal: [...hatchNormals.subarray(4 * corner, 4 * corner + 3)].map((value) => value / 32767),
    padding: hatchNormals[4 * corner + 3],
  }));
}

/** Degrees between two directions. */
function angleBetween(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, i) => sum + value * b[i], 0);
  return Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b)))) / DEGREES;
}

const faceNormal = (mesh: TriangleMesh, triangle: number): number[] => {
  const [a, b, c] = [0, 1, 2].map((k) => {
    const vertex = 3 * mesh.indices[3 * triangle + k];
    return [...mesh.positions.subarray(vertex, vertex + 3)];
  }) as [number[], number[], number[]];
  const u = b.map((value, i) => value - a[i]);
  const v = c.map((value, i) => value - a[i]);
  return [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
};

const rootMeanSquare = (values: readonly number[]): number =>
  Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);

/** The same mesh with every vertex moved by up to `amplitude` along each axis, the same for all at one position. */
function shaken(mesh: TriangleMesh, amplitude: number): TriangleMesh {
  const random = noise(5);
  const moves = new Map<string, number[]>();
  const positions = mesh.positions.slice();
  for (let i = 0; i < positions.length; i += 3) {
    const key = positions.subarray(i, i + 3).join(' ');
    const move = moves.get(key) ?? [random(), random(), random()];
    moves.set(key, move);
    for (let axis = 0; axis < 3; axis++) positions[i + axis] += amplitude * move[axis];
  }
  return { positions, indices: mesh.indices };
}

describe('edges of the form', () => {
  test.each([
    ['one square per side', cube(1)],
    ['the other diagonals', cube(1, 4)],
    ['64 squares per side', cube(8)],
    ['large triangles', cube(2, 9)],
  ])('a cube, %s, has exactly the normals of its faces', (_, mesh) => {
    for (const [corner, { normal }] of cornersOf(mesh).entries()) {
      const face = faceNormal(mesh, Math.floor(corner / 3));
      expect(normal.map((value) => value + 0)).toEqual(
        face.map((value) => Math.round(value / Math.hypot(...face)) + 0),
      );
    }
  });

  test('a hexagonal prism has the normals of its faces, at any scale; an octagonal one is round', () => {
    const worst = (sides: number, radius: number) => {
      const mesh = prism(sides);
      const corners = cornersOf(mesh, radius).slice(0, 6 * sides);
      return Math.max(
        ...corners.map(({ normal }, corner) => angleBetween(normal, faceNormal(mesh, Math.floor(corner / 3)))),
      );
    };
    expect(worst(6, 0.05)).toBeLessThan(0.01);
    expect(worst(6, 2)).toBeLessThan(0.01);
    expect(worst(8, 0.05)).toBeGreaterThan(20);
  });

  test('stay where there is noise', () => {
    const mesh = shaken(cube(24), 0.011);
    const noisy = cornersOf(mesh, 0.25);
    const clean = cornersOf(cube(24));
    const errors = noisy.map(({ normal }, corner) => angleBetween(normal, clean[corner].normal));
    expect(rootMeanSquare(errors)).toBeLessThan(3);
    expect(Math.max(...errors)).toBeLessThan(15);
  });
});

describe('noise', () => {
  /** A plane of 1 × 1 whose triangles are tilted by up to about 40 degrees. */
  const plane = () => {
    const random = noise(3);
    return patch(60, 60, (u, v) => [u, v, 0.005 * random()]);
  };
  const inside = ({ position: [x, y] }: { position: number[] }) => x! > 0.15 && x! < 0.85 && y! > 0.15 && y! < 0.85;
  const tilts = (mesh: TriangleMesh, radius: number) =>
    cornersOf(mesh, radius)
      .filter(inside)
      .map(({ normal }) => angleBetween(normal, [0, 0, 1]));

  test('a noisy plane becomes at least fifty times flatter', () => {
    const mesh = plane();
    const faces = Array.from({ length: mesh.indices.length / 3 }, (_, i) =>
      angleBetween(faceNormal(mesh, i), [0, 0, 1]),
    );
    expect(rootMeanSquare(faces)).toBeGreaterThan(14);
    expect(rootMeanSquare(tilts(mesh, 0.1))).toBeLessThan(rootMeanSquare(faces) / 50);
  });

  test('makes no edges on a plane', () => {
    const request = {
      label: 'test',
      mesh: plane(),
      creaseAngle: Math.PI / 2,
      smoothingRadius: 0.1,
      wantsNormals: false,
    };
    expect(finish(bakeIndexed(request)).addedVertices).toHaveLength(0);
  });

  test('a noisy sphere stays round', () => {
    const errors = cornersOf(shaken(sphere(40), 0.006), 0.15).map(({ position, normal }) =>
      angleBetween(position, normal),
    );
    expect(rootMeanSquare(errors)).toBeLessThan(1);
  });

  test('folds and doubled triangles too small for a stroke take the normals of the surface below them', () => {
    const flat = patch(10, 10, (u, v) => [u, v, 0]);
    const fold = meshOf(
      [
        [0.5, 0.5, 0],
        [0.6, 0.5, 0],
        [0.55, 0.5, 0.03],
      ],
      [
        [0, 1, 2],
        [0, 1, 2],
      ],
    );
    const corners = cornersOf(together(flat, fold), 0.2);
    // All but the tip, which belongs to the fold alone.
    for (const [i, { normal }] of corners.entries()) if (i < 600 || i % 3 < 2) expect(normal).toEqual([0, 0, 1]);
    // A fold as large as a stroke has normals of its own.
    const own = cornersOf(together(flat, fold), 0.02);
    expect(own[600].normal).toEqual([0, -1, 0]);
  });
});

describe('shape', () => {
  test.each([
    ['coarser', 16],
    ['finer', 32],
  ])('normals of a %s sphere are radial', (_, size) => {
    const errors = cornersOf(sphere(size), 0.2).map(({ position, normal }) => angleBetween(position, normal));
    expect(Math.max(...errors)).toBeLessThan(1);
  });

  test('a wave is flattened as by heat flow, whatever the triangles', () => {
    const wave = 2 * Math.PI * 4;
    const radius = 0.06;
    const slope = 0.05;
    const expected = slope * Math.exp(-((wave * radius) ** 2) / 4);
    for (const [columns, rows] of [
      [80, 80],
      [160, 80],
      [64, 128],
    ] as const) {
      const mesh = patch(columns, rows, (u, v) => [u, v, (slope / wave) * Math.sin(wave * u)]);
      // At the crest of the slope, far from the border.
      const corners = cornersOf(mesh, radius).filter(
        ({ position: [x, y] }) => Math.abs(x! - 0.5) < 1e-6 && Math.abs(y! - 0.5) < 0.2,
      );
      const measured = corners.reduce((sum, { normal: [x, , z] }) => sum - x! / z, 0) / corners.length;
      expect(measured / expected).toBeGreaterThan(0.93);
      expect(measured / expected).toBeLessThan(1.07);
    }
  });

  test('the same shape in few and in many triangles has the same normals', () => {
    // Large enough a radius to change the normals by much more than the difference.
    const normals = (around: number, across: number, radius: number) =>
      new Map(cornersOf(torus(around, across), radius).map(({ position, normal }) => [position.join(' '), normal]));
    const coarse = normals(60, 30, 0.3);
    const fine = normals(180, 90, 0.3);
    const differences = [...coarse].flatMap(([key, normal]) =>
      fine.has(key) ? [angleBetween(normal, fine.get(key)!)] : [],
    );
    expect(differences.length).toBeGreaterThan(500);
    expect(Math.max(...differences)).toBeLessThan(1.5);
  });

  test('a radius of 0 gives the mean normals; the default scales with the object', () => {
    const mesh = torus(30, 15);
    const scaled = { positions: mesh.positions.map((value) => 64 * value), indices: mesh.indices };
    const normals = (m: TriangleMesh, radius?: number) => cornersOf(m, radius).map(({ normal }) => normal);
    expect(normals(scaled)).toEqual(normals(mesh));
    expect(normals(mesh)).not.toEqual(normals(mesh, 0));
    const errors = cornersOf(mesh, 0).map(({ normal, position: [x, y, z] }) => {
      const ring = Math.hypot(x, y);
      return angleBetween(normal, [x! - x! / ring, y! - y! / ring, z]);
    });
    expect(Math.max(...errors)).toBeLessThan(6);
  });
});

test('the order of triangles and vertices does not matter, to rounding', () => {
  const mesh = shaken(sphere(12), 0.02);
  const random = noise(8);
  const order = [...Array(mesh.indices.length / 3).keys()]
    .map((i) => ({ i, key: random() }))
    .sort((a, b) => a.key - b.key);
  const shuffled = meshOf(
    Array.from({ length: mesh.positions.length / 3 }, (_, i) => [...mesh.positions.subarray(3 * i, 3 * i + 3)]),
    order.map(({ i }) => [...mesh.indices.subarray(3 * i, 3 * i + 3)]),
  );
  const before = cornersOf(mesh);
  const after = cornersOf(shuffled);
  for (const [to, { i }] of order.entries()) {
    for (let k = 0; k < 3; k++) {
      for (let axis = 0; axis < 3; axis++) {
        expect(Math.abs(after[3 * to + k].normal[axis] - before[3 * i + k].normal[axis])).toBeLessThan(1e-4);
      }
    }
  }
});

test('a fan of 20,000 triangles is one fan with one normal', () => {
  const corners = cornersOf(fan(20_000));
  expect(corners.every(({ normal, padding }) => normal[2] === 1 && padding === 0)).toBe(true);
});
