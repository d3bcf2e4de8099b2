import { CapsuleGeometry, CylinderGeometry, LatheGeometry, Vector2 } from 'three';
import { describe, expect, test } from 'vitest';
import type { FormOptions } from '../../../../../src/mesh/form/FormField.js';
import type { TriangleMesh } from '../../../../../src/mesh/TriangleMesh.js';
import { dot, meshFrom, moebius, scaled, turned, unit } from '../../features/surfaces.js';
import { book, fan, meshOf } from '../../meshes.js';
import { cube, patch, sphere, torus } from '../../shapes.js';
import { facesOf, frontOf, singularPoints } from '../fronts.js';

const degrees = (cosine: number) => (Math.acos(Math.min(1, Math.abs(cosine))) * 180) / Math.PI;

const capsule = () => meshFrom(new CapsuleGeometry(0.4, 1.4, 16, 48, 24));

const insideOut = ({ positions, indices }: TriangleMesh): TriangleMesh => {
  const reversed = indices.slice();
  for (let i = 0; i < indices.length; i += 3) reversed.subarray(i, i + 2).reverse();
  return { positions, indices: reversed };
};

/** A bump with several singular points around it. */
const bumpy = () => {
  const mesh = sphere(24);
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.subarray(i, i + 3);
    const radius = 1 + 0.3 * Math.sin(3 * x + 1) * Math.cos(2.5 * y) + 0.2 * Math.sin(4 * z + y);
    mesh.positions.set([radius * x, 1.3 * radius * y, radius * z], i);
  }
  return mesh;
};

/** A ball of radius 1 with a horn on it, half as thick in z as it is wide, that starts along y and bends towards −x. */
function horned(radius: number, length: number, bend: number): TriangleMesh {
  const base = Math.asin(radius);
  const profile = [
    ...Array.from({ length: 41 }, (_, i) => Math.PI - ((Math.PI - base) * i) / 40).map((t) => [
      Math.sin(t),
      Math.cos(t),
    ]),
    ...Array.from({ length: 40 }, (_, i) => [radius * (1 - (0.7 * (i + 1)) / 40), 1 + (length * (i + 1)) / 40]),
    [0, 1.01 + length],
  ];
  const mesh = meshFrom(
    new LatheGeometry(
      profile.map(([x, y]) => new Vector2(x, y)),
      32,
    ),
  );
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.subarray(i, i + 3);
    if (y <= 1) continue;
    const turn = bend * (y - 1);
    const out = 1 / bend + x;
    mesh.positions.set([out * Math.cos(turn) - 1 / bend, 1 + out * Math.sin(turn), 0.5 * z], i);
  }
  return mesh;
}

describe('lines run', () => {
  test('around a cylinder', () => {
    const front = frontOf(meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24, true)));
    for (const { across } of facesOf(front)) expect(degrees(across[1])).toBeLessThan(0.5);
  });

  test('around a capsule, wherever up is', () => {
    for (const up of [
      [0, 1, 0],
      [1, 0, 0],
      [0, 0, 0],
    ] as const) {
      const shaft = facesOf(frontOf(capsule(), { up })).filter(({ middle }) => Math.abs(middle[1]) < 0.5);
      expect(shaft.length).toBeGreaterThan(1000);
      for (const { across } of shaft) expect(degrees(across[1])).toBeLessThan(2.5);
    }
  });

  test('around a thin bent horn, though it grows on a ball', () => {
    const [length, bend] = [0.5, 2.5];
    const faces = facesOf(frontOf(horned(0.03, length, bend))).flatMap(({ middle: [x, y], across }) => {
      const turn = Math.atan2(y - 1, x + 1 / bend);
      const isHorn = y > 1.1 && turn > 0.1 * bend && turn < (length - 0.05) * bend;
      return isHorn ? [degrees(dot(across, [-Math.sin(turn), Math.cos(turn), 0]))] : [];
    });
    expect(faces.length).toBeGreaterThan(1000);
    expect(faces.sort((a, b) => a - b)[Math.floor(0.95 * faces.length)]).toBeLessThan(8);
  });

  test('around the tube of a torus', () => {
    const errors = facesOf(frontOf(torus(64, 32), { up: [0, 0, 0] })).map(({ middle, across }) =>
      degrees(dot(across, unit([-middle[1], middle[0], 0]))),
    );
    expect(errors.reduce((sum, error) => sum + error, 0) / errors.length).toBeLessThan(2);
    expect(Math.max(...errors)).toBeLessThan(8);
  });

  test('across up on a plane', () => {
    const plane = patch(12, 12, (u, v) => [u, v, 0]);
    for (const { across } of facesOf(frontOf(plane))) expect(degrees(across[1])).toBeLessThan(0.05);
    const tilted = facesOf(frontOf(plane, { up: [3, 4, 0] }));
    for (const { across } of tilted) expect(degrees(dot(across, [0.6, 0.8, 0]))).toBeLessThan(0.05);
  });

  test('along one axis on lids, across the front', () => {
    const cylinder = meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24));
    const lids = (front?: FormOptions['front']) =>
      facesOf(frontOf(cylinder, { front })).filter(({ middle }) => Math.abs(middle[1]) > 0.99);
    expect(lids().length).toBeGreaterThan(50);
    for (const { across } of lids()) expect(degrees(across[2])).toBeLessThan(0.5);
    for (const { across } of lids([2, 0, 0])) expect(degrees(across[0])).toBeLessThan(0.5);
  });

  test('around a beaker with a wall, outside and inside', () => {
    const profile = [
      [0, 0],
      [0.5, 0],
      [0.6, 1.5],
      [0.5, 1.5],
      [0.4, 0.1],
      [0, 0.1],
    ];
    const points = profile.slice(1).flatMap(([r, y], i) => {
      const [r0, y0] = profile[i];
      return Array.from({ length: 12 }, (_, k) => new Vector2(r0 + ((r - r0) * k) / 12, y0 + ((y - y0) * k) / 12));
    });
    const walls = facesOf(frontOf(meshFrom(new LatheGeometry(points, 64)))).filter(
      ({ middle: [x, y, z] }) => Math.hypot(x, z) > 0.3 && y > 0.3 && y < 1.3,
    );
    const inside = walls.filter(({ middle: [x, y, z] }) => Math.hypot(x, z) < 0.45 + 0.1 * (y / 1.5)).length;
    expect(inside / walls.length).toBeCloseTo(0.5, 1);
    for (const { across } of walls) expect(Math.abs(across[1])).toBeGreaterThan(0.98);
  });

  test('the same way on a mesh wound inside out', () => {
    const faces = facesOf(frontOf(capsule()));
    const reversed = facesOf(frontOf(insideOut(capsule())));
    for (const [i, { across, middle }] of faces.entries()) {
      if (Math.abs(middle[1]) < 0.6) expect(degrees(dot(across, reversed[i].across))).toBeLessThan(0.5);
    }
  });
});

describe('directions are the same', () => {
  test('to the bit, in a second run', () => {
    const [first, second] = [frontOf(bumpy()), frontOf(bumpy())];
    expect(first.field).toEqual(second.field);
    expect(first.directions).toEqual(second.directions);
    expect(first.seam).toEqual(second.seam);
  });

  test('on a mesh a thousand times as large, elsewhere', () => {
    const mesh = bumpy();
    const front = frontOf(mesh);
    const moved = scaled(mesh, 1024);
    for (let i = 0; i < moved.positions.length; i++) moved.positions[i] += [4096, -2048, 1024][i % 3];
    const other = frontOf(moved);
    expect(singularPoints(other)).toHaveLength(singularPoints(front).length);
    const faces = facesOf(other);
    const errors = facesOf(front).map(({ across }, i) => degrees(dot(across, faces[i].across)));
    expect(errors.filter((error) => error > 2).length).toBeLessThan(0.01 * errors.length);
  });

  test('on a mesh that is turned together with its up and its front', () => {
    const mesh = bumpy();
    const front = frontOf(mesh);
    const quaternion = [0.3, -0.5, 0.2, 0.8];
    const turn = (row: readonly number[]) =>
      [...turned(meshOf([row], []), quaternion).positions] as [number, number, number];
    const other = frontOf(turned(mesh, quaternion), { up: turn([0, 1, 0]), front: turn([0, 0, 1]) });
    expect(singularPoints(other)).toHaveLength(singularPoints(front).length);
    const faces = facesOf(other);
    const errors = facesOf(front).map(({ across }, i) => degrees(dot(turn(across), faces[i].across)));
    expect(errors.filter((error) => error > 2).length).toBeLessThan(0.01 * errors.length);
  });
});

describe('singular points leave the front', () => {
  const VIEWS = [
    [0, 0, 1],
    [1, 0, 0],
    [0, -3, 4],
    [-1, 2, -2],
  ] as const;

  test.each([
    ['a ball', sphere(20)],
    ['a body with bumps', bumpy()],
  ])('of %s', (_, mesh) => {
    /** How much singular points show from a side, when the field knows that it is seen from `front`. */
    const shown = (side: readonly number[], front: FormOptions['front']) =>
      singularPoints(frontOf(mesh, { up: [0, 0, 0], front }))
        .map((point) => Math.max(0, dot(unit(point), unit(side))))
        .reduce((sum, value) => sum + value, 0);
    const sum = (values: number[]) => values.reduce((all, value) => all + value, 0);
    const unknown = sum(VIEWS.map((side) => shown(side, [0, 0, 0])));
    expect(sum(VIEWS.map((side) => shown(side, side)))).toBeLessThan(0.75 * unknown);
  });

  test('which is z where none is named, and −y where up is z', () => {
    const points = (options: Partial<FormOptions>) => singularPoints(frontOf(bumpy(), options));
    expect(points({})).toEqual(points({ front: [0, 0, 1] }));
    expect(points({ up: [0, 0, 2] })).toEqual(points({ up: [0, 0, 1], front: [0, -1, 0] }));
    expect(points({})).not.toEqual(points({ front: [0, 0, -1] }));
  });
});

test('damaged meshes have no NaN directions', () => {
  const flat = meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
      [0, 0, 0],
    ],
    [
      [0, 1, 2],
      [1, 2, 3],
      [0, 0, 0],
    ],
  );
  const doubled = meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
    [
      [0, 1, 2],
      [2, 1, 0],
    ],
  );
  const needle = scaled(cube(3), 1);
  for (let i = 0; i < needle.positions.length; i += 3) needle.positions[i] *= 1e-7;
  const damaged = [meshOf([], []), flat, doubled, needle, book(5), fan(3), fan(3000), moebius(20, 4), cube(1)];
  for (const mesh of [
    ...damaged,
    ...damaged.map((mesh) => scaled(mesh, 1e-18)),
    ...damaged.map((mesh) => scaled(mesh, 1e15)),
  ]) {
    const { directions, field } = frontOf(mesh);
    for (const values of [directions.across, directions.normals]) {
      for (let i = 0; i < values.length; i += 3) expect(Math.hypot(...values.subarray(i, i + 3))).toBeCloseTo(1, 4);
    }
    expect(field.lines.every(Number.isFinite)).toBe(true);
  }
});
