import { describe, expect, test } from 'vitest';
import { fanCurvatures, TENSOR_FLOATS } from '../../../../src/mesh/features/fanCurvatures.js';
import { computeSmoothNormals } from '../../../../src/mesh/normals/fanNormals.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish, meshOf } from '../meshes.js';
import { cube, noise, patch, sphere, torus } from '../shapes.js';
import { cross, dot, fanPositions, outlinesOf, perFan, type Row, scaled, surfaceOf, unit } from './surfaces.js';

/** K·w */
const times = ([xx, xy, xz, yy, yz, zz]: Row, [x, y, z]: Row): number[] => [
  xx * x + xy * y + xz * z,
  xy * x + yy * y + yz * z,
  xz * x + yz * y + zz * z,
];

const along = (tensor: Row, w: Row): number => dot(w, times(tensor, w));

const rowsOf = (values: Float32Array, length: number): number[][] =>
  Array.from({ length: values.length / length }, (_, i) => [...values.subarray(length * i, length * (i + 1))]);

/** Position, normal and tensor of each fan, with the given or the mean normals. */
function fansOf(mesh: TriangleMesh, direction?: (position: Row) => Row) {
  const { areaNormals, fans } = surfaceOf(mesh);
  const normals = direction ? perFan(mesh, fans, direction) : finish(computeSmoothNormals(areaNormals, fans));
  const tensors = rowsOf(finish(fanCurvatures(mesh, areaNormals, fans, normals)), TENSOR_FLOATS);
  const directions = rowsOf(normals, 3);
  return fanPositions(mesh, fans.ofCorner).map((position, i) => ({
    position,
    normal: directions[i],
    tensor: tensors[i],
  }));
}

/** Unit tangents in several directions. */
const tangentsAt = (normal: Row): number[][] =>
  [
    [1, 2.1, 3.2],
    [-3, 1.1, 1.2],
    [2, -3.1, 1.2],
    [0.12, 0.21, -1],
  ].map((w) => unit(cross(normal, w)));

const ringOf = ([x, y]: Row) => [x / Math.hypot(x, y), y / Math.hypot(x, y), 0];

/** Relative errors of the curvature along tangents of each fan. */
const errorsOf = (fans: ReturnType<typeof fansOf>, expected: number): number[] =>
  fans.flatMap(({ normal, tensor }) => tangentsAt(normal).map((w) => Math.abs(along(tensor, w) / expected - 1)));

const rootMeanSquare = (values: readonly number[]): number =>
  Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);

describe('a sphere', () => {
  test.each([0.01, 1, 300])('of radius %f has 1/r along every tangent', (radius) => {
    expect(Math.max(...errorsOf(fansOf(scaled(sphere(7), radius), unit), 1 / radius))).toBeLessThan(1e-4);
  });

  test('has 1/r within some per cent with normals that are means of those of its triangles, and with those of the bake', () => {
    const radius = 2;
    const mesh = scaled(sphere(14), radius);
    const { fans, normals, curvatures } = outlinesOf(mesh);
    const tensors = rowsOf(curvatures, TENSOR_FLOATS);
    const position = [0, 0, 0];
    const baked = rowsOf(normals, 3).map((normal, i) => ({ position, normal, tensor: tensors[i] }));
    expect(baked).toHaveLength(fans.count);
    for (const found of [fansOf(mesh), baked]) {
      const errors = errorsOf(found, 1 / radius);
      expect(rootMeanSquare(errors)).toBeLessThan(0.07);
      expect(Math.max(...errors)).toBeLessThan(0.2);
    }
  });

  test('turned inside out is hollow: −1/r', () => {
    const mesh = sphere(6);
    for (let i = 0; i < mesh.indices.length; i += 3) mesh.indices.subarray(i, i + 2).reverse();
    const fans = fansOf(mesh, (position) => unit(position).map((value) => -value));
    expect(Math.max(...errorsOf(fans, -1))).toBeLessThan(1e-4);
  });
});

test('a cylinder has 1/r across, 0 along, and half of it between', () => {
  const radius = 0.5;
  const mesh = patch(24, 6, (u, v) => [
    radius * Math.cos(2 * Math.PI * (u % 1)),
    radius * Math.sin(2 * Math.PI * (u % 1)),
    v,
  ]);
  for (const { normal, tensor } of fansOf(mesh, ringOf)) {
    const across = cross([0, 0, 1], normal);
    expect(along(tensor, across)).toBeCloseTo(1 / radius, 4);
    expect(along(tensor, [0, 0, 1])).toBeCloseTo(0, 4);
    expect(along(tensor, unit([...across.slice(0, 2), 1]))).toBeCloseTo(0.5 / radius, 4);
  }
});

test('a torus is convex outside, a saddle inside, and bent across everywhere', () => {
  const fans = fansOf(torus(60, 30), ([x, y, z]) => {
    const [ringX, ringY] = ringOf([x, y]);
    return unit([x - ringX, y - ringY, z]);
  }).map(({ position, normal, tensor }) => {
    const ring = ringOf(position);
    const around = [-ring[1], ring[0], 0];
    return {
      cosine: dot(normal, ring),
      around: along(tensor, around),
      across: along(tensor, cross(normal, around)),
      twist: dot(cross(normal, around), times(tensor, around)),
    };
  });
  const errors = fans.map(({ cosine, around }) => around - cosine / (1 + 0.4 * cosine));
  expect(rootMeanSquare(errors)).toBeLessThan(0.05);
  expect(rootMeanSquare(fans.map(({ across }) => 0.4 * across - 1))).toBeLessThan(0.05);
  expect(rootMeanSquare(fans.map(({ twist }) => twist))).toBeLessThan(0.1);
  const outside = fans.filter(({ cosine }) => cosine > 0.2);
  const inside = fans.filter(({ cosine }) => cosine < -0.2);
  expect(Math.min(outside.length, inside.length)).toBeGreaterThan(500);
  expect(outside.every(({ around, across }) => around > 0 && across > 0)).toBe(true);
  expect(inside.every(({ around, across }) => around < 0 && across > 0)).toBe(true);
});

test('a plane and the sides of a cube have zero curvature', () => {
  const plane = patch(5, 4, (u, v) => [3 * u, v, 0.5 * u - v]);
  for (const { tensor } of [...fansOf(plane), ...fansOf(cube(3))]) {
    for (const value of tensor) expect(value).toBeCloseTo(0, 6);
  }
});

test('the tensor takes the normal to zero', () => {
  const random = noise(4);
  const bumpy = patch(12, 12, (u, v) => [u, v, 0.1 * Math.sin(7 * u) * Math.cos(5 * v) + 0.01 * random()]);
  for (const { normal, tensor } of [...fansOf(bumpy), ...fansOf(torus(20, 12))]) {
    expect(Math.hypot(...times(tensor, normal))).toBeLessThan(1e-5 * Math.max(1, Math.hypot(...tensor)));
  }
});

test('a mesh twice as large is half as curved', () => {
  const mesh = torus(20, 12);
  const large = fansOf(scaled(mesh, 2));
  for (const [i, { tensor }] of fansOf(mesh).entries()) {
    expect(Math.hypot(...tensor)).toBeGreaterThan(0.1);
    for (const [k, value] of tensor.entries()) expect(large[i].tensor[k]).toBeCloseTo(value / 2, 5);
  }
});

test('triangles count by their area', () => {
  const vertices = [
    [0, 0, 0],
    [0, 1, 0],
    [4, 0, 0],
    [-1, 0, 0],
  ];
  // Only the normal of the right vertex differs: the left triangle, a fifth of the area, is flat.
  const normals = new Float32Array([0, 0, 1, 0, 0, 1, 0.28, 0, 0.96, 0, 0, 1]);
  const tensorsOf = (triangles: Row[]) => {
    const mesh = meshOf(vertices, triangles);
    const { areaNormals } = surfaceOf(mesh);
    const fans = { ofCorner: mesh.indices, count: vertices.length };
    return rowsOf(finish(fanCurvatures(mesh, areaNormals, fans, normals)), TENSOR_FLOATS);
  };
  const [alone] = tensorsOf([[0, 2, 1]]);
  const [atBoth, , , onLeft] = tensorsOf([
    [0, 2, 1],
    [0, 1, 3],
  ]);
  expect(Math.hypot(...alone)).toBeGreaterThan(0.05);
  for (const [k, value] of alone.entries()) expect(atBoth[k]).toBeCloseTo(0.8 * value, 6);
  expect(onLeft.map(Math.abs)).toEqual([0, 0, 0, 0, 0, 0]);
});

describe('triangles without a measurable curvature', () => {
  /** A sphere with one triangle more, whose corners belong to the given fans. */
  function withTriangle(corners: readonly Row[], fansOfCorners: readonly number[]) {
    const mesh = sphere(4);
    const { fans } = surfaceOf(mesh);
    const first = mesh.positions.length / 3;
    const larger = {
      positions: new Float32Array([...mesh.positions, ...corners.flat()]),
      indices: new Uint32Array([...mesh.indices, first, first + 1, first + 2]),
    };
    const { areaNormals } = surfaceOf(larger);
    const normals = perFan(mesh, fans, unit);
    const both = { ofCorner: new Uint32Array([...fans.ofCorner, ...fansOfCorners]), count: fans.count };
    return {
      with: finish(fanCurvatures(larger, areaNormals, both, normals)),
      without: finish(fanCurvatures(mesh, surfaceOf(mesh).areaNormals, fans, normals)),
    };
  }

  test.each<[string, Row[]]>([
    [
      'a point',
      [
        [0, 0, 1],
        [0, 0, 1],
        [0, 0, 1],
      ],
    ],
    [
      'a line',
      [
        [0, 0, 1],
        [0, 0, 2],
        [0, 0, 3],
      ],
    ],
    [
      'two corners at one place',
      [
        [0, 0, 1],
        [0, 0, 1],
        [1, 0, 1],
      ],
    ],
    [
      'a needle',
      [
        [0, 0, 1],
        [1, 0, 1],
        [0.5, 1e-5, 1],
      ],
    ],
  ])('%s counts for nothing', (_, corners) => {
    const result = withTriangle(corners, [0, 20, 40]);
    expect(result.with).toEqual(result.without);
  });

  test('nor does one that lies on its back', () => {
    const mesh = sphere(4);
    const top = fanPositions(mesh, surfaceOf(mesh).fans.ofCorner).findIndex((position) => position[2] === 1);
    const corners = [
      [0, 0, 1],
      [0, 1, 1],
      [1, 0, 1],
    ];
    const result = withTriangle(corners, [top, top + 1, top + 2]);
    const from = TENSOR_FLOATS * top;
    expect(result.with.slice(from, from + TENSOR_FLOATS)).toEqual(result.without.slice(from, from + TENSOR_FLOATS));
    const upright = withTriangle(corners.toReversed(), [top, top + 1, top + 2]);
    expect(upright.with.slice(from, from + TENSOR_FLOATS)).not.toEqual(
      upright.without.slice(from, from + TENSOR_FLOATS),
    );
  });

  test('there is never a NaN', () => {
    const random = noise(11);
    for (const scale of [1e-20, 1, 1e18]) {
      const mesh = patch(6, 6, () => [
        scale * Math.round(2 * random()),
        scale * Math.round(2 * random()),
        scale * random(),
      ]);
      for (const { tensor } of fansOf(mesh)) expect(tensor.every(Number.isFinite)).toBe(true);
    }
  });
});
