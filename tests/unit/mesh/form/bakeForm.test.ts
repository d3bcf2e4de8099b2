import { CapsuleGeometry, CylinderGeometry, TorusGeometry, TorusKnotGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { FormField } from '../../../../src/mesh/form/FormField.js';
import { multiply } from '../../../../src/mesh/form/phase/PhaseSystem.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { meshFrom, moebius } from '../features/surfaces.js';
import { book, fan, finish, meshOf } from '../meshes.js';
import { cube, noise, patch, sphere, together, torus } from '../shapes.js';
import { formOf, jumpsOf, kinksOf, lineLengths, phaseOf } from './phases.js';

const knot = () => meshFrom(new TorusKnotGeometry(0.7, 0.24, 160, 24, 2, 3));
const capsule = () => meshFrom(new CapsuleGeometry(0.4, 1.4, 16, 48, 24));
const cylinder = () => meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24, true));

/** No axis attracts lines. */
const NO_AXIS = { up: [0, 0, 0] } as const;

const lying = ({ positions, indices }: TriangleMesh, shift: number): TriangleMesh => ({
  positions: positions.map((value, i) => (i % 3 === 0 ? value + shift : value)),
  indices,
});

/** A sphere with noise of a third of an edge on each coordinate. */
function noisySphere(size = 12): TriangleMesh {
  const { positions, indices } = sphere(size);
  const places = new Map<string, number[]>();
  const random = noise(7);
  const moved = positions.slice();
  for (let i = 0; i < positions.length; i += 3) {
    const key = positions.subarray(i, i + 3).join();
    const place = places.get(key) ?? [...positions.subarray(i, i + 3)].map((value) => value + (0.36 / size) * random());
    places.set(key, place);
    moved.set(place, i);
  }
  return { positions: moved, indices };
}

const SHAPES: [string, () => TriangleMesh][] = [
  ['a sphere', () => sphere(16)],
  ['a cube with its creases', () => cube(6)],
  ['a torus', () => torus(48, 24)],
  ['a knot', knot],
  ['a capsule', capsule],
  ['an open cylinder', cylinder],
  ['a Möbius strip', () => moebius(48, 6)],
  ['a sphere with noise', () => noisySphere()],
  ['three parts', () => together(sphere(8), lying(torus(40, 20), 3), lying(cube(5), -3))],
];

describe('lines go on across the cut', () => {
  test.each(SHAPES)(
    'jumps are multiples of 4, and of 2 for lines that cross, and the same at both ends of an edge: %s',
    (_, shape) => {
      const whole = phaseOf(shape());
      for (const [family, multiple] of [
        [0, 4],
        [1, 2],
      ] as const) {
        for (const [atStart, atEnd] of jumpsOf(whole, family)) {
          expect(Math.abs(atStart - multiple * Math.round(atStart / multiple))).toBeLessThan(1e-9);
          expect(Math.abs(atStart - atEnd)).toBeLessThan(1e-9);
        }
      }
    },
  );

  test('a torus has no singular point, and all its lines are closed: 64 rings around the tube', () => {
    const whole = phaseOf(meshFrom(new TorusGeometry(1, 0.42, 32, 64)), NO_AXIS);
    expect(whole.field.statistics.singularPoints).toBe(0);
    const lengths = lineLengths(whole, 0);
    expect(lengths).toHaveLength(64);
    for (const length of lengths) expect(length).toBeCloseTo(2 * Math.PI * 0.42, 1);
  });
});

test('the parts of an assembly converge independently: each torus has a suitable number of rings', () => {
  const shapes = [1, 0.5, 0.2, 0.05].map((size, i) => {
    const { positions, indices } = torus(48, 24);
    return { positions: positions.map((value, k) => size * value + (k % 3 === 0 ? 4 * i : 0)), indices };
  });
  const whole = phaseOf(together(...shapes), NO_AXIS);
  const corners = shapes[0].indices.length;
  for (const [i, size] of [1, 0.5, 0.2, 0.05].entries()) {
    // Once around the torus φ rises by the number of rings, which is the jump at the cut.
    const ideal = (2 * Math.PI * 16 * size * Math.sqrt(1 - 0.4 ** 2)) / whole.surface.radius;
    const jumps = jumpsOf(whole, 0, i * corners, (i + 1) * corners).map(([jump]) => Math.abs(jump));
    expect(jumps.some((jump) => Math.abs(jump - ideal) <= 2 && jump > 0)).toBe(true);
  }
});

describe('φ rises as it should', () => {
  test.each(SHAPES)('what is left of the forces is small: %s', (_, shape) => {
    const { matrix, source, phase } = phaseOf(shape());
    const product = new Float64Array(phase.nodes.length);
    finish(multiply(matrix, phase.nodes, product));
    const lengthOf = (values: Float64Array) => Math.hypot(...values);
    // The solver has subtracted the effect of jumps from the forces on the nodes.
    expect(lengthOf(source.forces.map((force, i) => force - product[i]))).toBeLessThan(0.02 * lengthOf(source.forces));
  });

  test('on an open cylinder φ = ±16 y + c', () => {
    const whole = phaseOf(cylinder());
    const { mesh, surface, valueAt } = whole;
    const slope = 16 / surface.radius;
    const rest = (sign: number) => {
      const values = [...mesh.indices].map(
        (vertex, corner) => valueAt(corner, 0) - sign * slope * mesh.positions[3 * vertex + 1],
      );
      return Math.max(...values) - Math.min(...values);
    };
    expect(Math.min(rest(1), rest(-1))).toBeLessThan(0.03);
  });
});

test.each([
  ['a sphere', () => sphere(45)],
  ['a torus', () => torus(160, 80)],
  ['a sphere with noise', () => noisySphere(45)],
])('of 24,000 triangles, %s gets at most 5 %% more vertices', (_, shape) => {
  const { field, surface } = phaseOf(shape());
  expect(field.statistics.addedVertices).toBe(field.count - surface.fans.count);
  expect(field.statistics.addedVertices).toBeLessThan(0.05 * surface.fans.count);
});

test('lines of a torus of 576 triangles hardly turn at edges', () => {
  const kinks = kinksOf(phaseOf(meshFrom(new TorusGeometry(1, 0.42, 12, 24)))).sort((a, b) => a - b);
  expect(kinks[kinks.length >> 1]).toBeLessThan(0.3);
  expect(kinks[Math.floor(0.95 * kinks.length)]).toBeLessThan(3);
});

describe('the field depends on the shape alone', () => {
  /** The largest difference of φ or φ₂ at any corner. */
  const worst = (a: FormField, b: FormField) =>
    a.ofCorner.reduce((most, vertex, corner) => {
      const other = b.ofCorner[corner];
      const differences = [0, 1].map((family) =>
        Math.abs(a.values[2 * vertex + family] - b.values[2 * other + family]),
      );
      return Math.max(most, ...differences);
    }, 0);

  test.each([
    ['a torus', () => torus(48, 24)],
    ['a cylinder', cylinder],
    ['a knot', knot],
  ])('scaled and moved: %s', (_, shape) => {
    const { positions, indices } = shape();
    const moved = { positions: positions.map((value, i) => 1000 * value + [500, -200, 100][i % 3]), indices };
    const [a, b] = [formOf({ positions, indices }, NO_AXIS), formOf(moved, NO_AXIS)];
    expect(worst(a, b)).toBeLessThan(5e-5);
  });

  test('two bakes give the same bits', () => {
    expect(formOf(knot())).toEqual(formOf(knot()));
  });

  test('only φ₂ depends on the angle between the families', () => {
    const [a, b] = [0.5, 1.5].map((crossAngle) => phaseOf(knot(), { crossAngle }));
    const values = ({ mesh, valueAt }: typeof a, family: 0 | 1) =>
      [...mesh.indices.keys()].map((corner) => valueAt(corner, family));
    expect(values(a, 0)).toEqual(values(b, 0));
    expect(values(a, 1)).not.toEqual(values(b, 1));
  });
});

describe('odd meshes', () => {
  const soup = (count: number, seed: number) => {
    const random = noise(seed);
    return meshOf(
      Array.from({ length: 30 }, () => [random(), random(), random()]),
      Array.from({ length: count }, () => [0, 1, 2].map(() => Math.floor(15 * (random() + 1)))),
    );
  };

  test.each<[string, () => TriangleMesh]>([
    [
      'a triangle',
      () =>
        meshOf(
          [
            [0, 0, 0],
            [1, 0, 0],
            [0, 1, 0],
          ],
          [[0, 1, 2]],
        ),
    ],
    [
      'a triangle without area',
      () =>
        meshOf(
          [
            [0, 0, 0],
            [1, 0, 0],
            [2, 0, 0],
          ],
          [[0, 1, 2]],
        ),
    ],
    ['a point', () => meshOf([[1, 2, 3]], [[0, 0, 0]])],
    ['a fan of 5,000 triangles', () => fan(5000)],
    ['a book of 50 pages', () => book(50)],
    ['a plane with folds of no area', () => patch(9, 9, (u, v) => [Math.floor(5 * u) / 5, v, 0])],
    ['a sphere of noise', () => noisySphere()],
    ...Array.from({ length: 30 }, (_, seed): [string, () => TriangleMesh] => [
      `triangles of chance, ${seed}`,
      () => soup(10 + 7 * seed, seed),
    ]),
  ])('%s has a field of numbers', (_, shape) => {
    const mesh = shape();
    const { count, ofCorner, values, slopes, crossings } = formOf(mesh);
    expect(ofCorner).toHaveLength(mesh.indices.length);
    expect(Math.max(...ofCorner)).toBe(count - 1);
    expect([values.length, slopes.length, crossings.length]).toEqual([2 * count, 3 * count, 3 * count]);
    for (const numbers of [values, slopes, crossings]) expect(numbers.every(Number.isFinite)).toBe(true);
  });
});
