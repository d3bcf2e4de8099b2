import {
  BoxGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type Object3D,
  PlaneGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { PlainMesh } from '../../../../../src/viewer/files/mesh/PlainMesh.js';
import { mergeScene } from '../../../../../src/viewer/files/scenes/mergeScene.js';
import { measure } from '../../../../../tools/modelFiles/modelWriters.js';

const volumeOf = (mesh: PlainMesh): number => measure({ mesh } as Parameters<typeof measure>[0]).volume;

/** The least and the greatest coordinate along an axis. */
const reach = ({ positions }: PlainMesh, axis: number): number[] => {
  const values = [...positions].filter((_, i) => i % 3 === axis);
  return [Math.min(...values), Math.max(...values)];
};

test('a mirrored part is not turned inside out', () => {
  const box = new Mesh(new BoxGeometry(1, 2, 3));
  expect(volumeOf(mergeScene(new Group().add(box)))).toBeCloseTo(6);
  box.scale.x = -1;
  expect(volumeOf(mergeScene(new Group().add(box)))).toBeCloseTo(6);
  const parts = new Mesh(new BoxGeometry(1, 2, 3), Array(6).fill(new MeshBasicMaterial()));
  parts.scale.set(1, 1, -1);
  expect(volumeOf(mergeScene(new Group().add(parts)))).toBeCloseTo(6);
});

test('instances are placed relative to their mesh', () => {
  const boxes = new InstancedMesh(new BoxGeometry(2, 2, 2), new MeshBasicMaterial(), 2);
  boxes.setMatrixAt(0, new Matrix4());
  boxes.setMatrixAt(1, new Matrix4().makeTranslation(10, 0, 0));
  boxes.position.y = 5;
  const root = new Group().add(boxes);
  root.scale.setScalar(2);
  const merged = mergeScene(root);
  expect([reach(merged, 0), reach(merged, 1), reach(merged, 2)]).toEqual([
    [-2, 22],
    [8, 12],
    [-2, 2],
  ]);
});

describe('paints', () => {
  const painted = (color: number, parameters = {}) =>
    new Mesh(new PlaneGeometry(), new MeshBasicMaterial({ color, ...parameters }));
  const rangesOf = (...meshes: Object3D[]) => mergeScene(new Group().add(...meshes)).ranges;

  test('have a range for each colour, the most frequent first, and glass has one of its own', () => {
    const glass = painted(0x00ff00, { transparent: true, opacity: 0.5 });
    expect(rangesOf(painted(0xff0000), painted(0x0000ff), painted(0x0000ff), glass)).toEqual([
      { start: 0, count: 12, picture: -1, paint: '0000ff' },
      { start: 12, count: 6, picture: -1, paint: 'ff0000' },
      { start: 18, count: 6, picture: -1, isSeeThrough: true },
    ]);
  });

  test('of one colour have none', () => {
    expect(rangesOf(painted(0xff0000), painted(0xff0000))).toBeUndefined();
  });

  test('beyond 32 are in the range of the most frequent', () => {
    const many = Array.from({ length: 40 }, (_, i) => painted(i));
    const ranges = rangesOf(painted(0xffffff), painted(0xffffff), ...many)!;
    expect(ranges).toHaveLength(32);
    expect(ranges[0]).toMatchObject({ count: 6 * 11, paint: 'ffffff' });
    expect(ranges.reduce((sum, { count }) => sum + count, 0)).toBe(6 * 42);
  });
});

test('many small parts have ranges of their own for each colour', () => {
  const stones = Array.from({ length: 30 }, (_, i) => {
    const color = i % 2 ? 0xff0000 : 0x0000ff;
    const stone = new Mesh(new PlaneGeometry(0.1, 0.1), new MeshBasicMaterial({ color }));
    stone.position.x = i / 10;
    return stone;
  });
  const plate = new Mesh(new PlaneGeometry(10, 10), new MeshBasicMaterial({ color: 0xff0000 }));
  expect(mergeScene(new Group().add(plate, ...stones)).ranges).toEqual([
    { start: 0, count: 6, picture: -1, paint: 'ff0000' },
    { start: 6, count: 90, picture: -1, paint: 'ff0000', isOfSmallParts: true },
    { start: 96, count: 90, picture: -1, paint: '0000ff', isOfSmallParts: true },
  ]);
  expect(mergeScene(new Group().add(plate, ...stones.slice(7))).ranges).toHaveLength(2);
});

test('smooth metal has a range of its own, and rough metal, plastic and glass have none', () => {
  const surfaces = [
    { metalness: 1, roughness: 0.2 },
    { metalness: 1, roughness: 0.9 },
    { metalness: 0.5, roughness: 0.4 },
    { metalness: 0, roughness: 0 },
    { metalness: 1, roughness: 0, transparent: true, opacity: 0.3 },
  ];
  const meshes = surfaces.map((surface) => new Mesh(new PlaneGeometry(), new MeshStandardMaterial(surface)));
  expect(mergeScene(new Group().add(...meshes)).ranges).toEqual([
    { start: 0, count: 12, picture: -1 },
    { start: 12, count: 6, picture: -1, mirrors: 0.5 },
    { start: 18, count: 6, picture: -1, mirrors: 1 },
    { start: 24, count: 6, picture: -1, isSeeThrough: true },
  ]);
  const [ball] = meshes;
  expect(mergeScene(new Group().add(ball)).ranges).toEqual([{ start: 0, count: 6, picture: -1, mirrors: 1 }]);
});

describe('sides', () => {
  const sheet = () => new PlaneGeometry();
  const both = new MeshBasicMaterial({ side: DoubleSide });
  const merged = (...meshes: Object3D[]) =>
    mergeScene(new Group().add(...meshes), undefined, undefined, undefined, true);

  test('are those of the materials, in ranges where they differ', () => {
    const one = new Mesh(sheet(), new MeshBasicMaterial());
    const glass = new Mesh(sheet(), new MeshBasicMaterial({ transparent: true, opacity: 0.5 }));
    const double = new Mesh(sheet(), both);
    expect(merged(one)).toMatchObject({ isOneSided: true });
    expect(merged(double)).toMatchObject({ isOneSided: false });
    expect(merged(one, double, one.clone(), glass).ranges).toEqual([
      { start: 0, count: 6, picture: -1, isOneSided: false },
      { start: 6, count: 12, picture: -1, isOneSided: true },
      { start: 18, count: 6, picture: -1, isOneSided: true, isSeeThrough: true },
    ]);
    const unsaid = mergeScene(new Group().add(one.clone(), double.clone()));
    expect([unsaid.isOneSided, unsaid.ranges]).toEqual([undefined, undefined]);
  });

  test('of mirrored meshes are turned as in three.js, and those of mirrored instances of one-sided ones are not', () => {
    const frontOf = ({ positions, indices }: PlainMesh): number => {
      const [a, b, c] = [0, 1, 2].map((k) => new Vector3().fromArray(positions, 3 * indices![k]));
      return b.sub(a).cross(c.sub(a)).z;
    };
    const mirror = new Matrix4().makeScale(-1, 1, 1);
    for (const [material, expected] of [
      [new MeshBasicMaterial(), -1],
      [both, 1],
    ] as const) {
      const instances = new InstancedMesh(sheet(), material, 1);
      instances.setMatrixAt(0, mirror);
      expect(frontOf(merged(instances))).toBe(expected);
    }
    const mesh = new Mesh(sheet(), new MeshBasicMaterial());
    mesh.applyMatrix4(mirror);
    expect(frontOf(merged(mesh))).toBe(1);
    const nested = new Group().add(mesh);
    nested.applyMatrix4(mirror);
    expect(frontOf(merged(nested))).toBe(1);
  });
});
