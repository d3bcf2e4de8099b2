import { Box3, type BufferGeometry, type Mesh, type MeshStandardMaterial } from 'three';
import { describe, expect, test } from 'vitest';
import { makeDrapery } from '../../../../src/playground/models/makeDrapery.js';
import { makeFox } from '../../../../src/playground/models/makeFox.js';
import { makeHouse } from '../../../../src/playground/models/makeHouse.js';
import { makeRoom } from '../../../../src/playground/models/makeRoom.js';
import { makeStairs } from '../../../../src/playground/models/makeStairs.js';
import { makeStreet } from '../../../../src/playground/models/makeStreet.js';

const trianglesOf = ({ index, attributes }: BufferGeometry): number => (index ?? attributes.position).count / 3;

/** What makes each scene, and between which numbers of triangles it has. */
const MADE = [
  [makeHouse, 2000, 20_000],
  [makeDrapery, 2000, 20_000],
  [makeStairs, 2000, 30_000],
  [makeRoom, 2000, 30_000],
  [makeStreet, 2000, 30_000],
  [makeFox, 60, 160],
] as const;

describe.each(MADE.map(([make, ...counts]) => [make.name, make, counts] as const))('%s', (_, make, [fewest, most]) => {
  const { root } = make();
  const meshes = root.children as Mesh<BufferGeometry, MeshStandardMaterial>[];

  test('has as many triangles as such a thing needs and makes the same ones again', () => {
    const counts = meshes.map(({ geometry }) => trianglesOf(geometry));
    const sum = counts.reduce((all, count) => all + count);
    expect(sum).toBeGreaterThan(fewest);
    expect(sum).toBeLessThan(most);
    const again = make().root.children as Mesh[];
    for (const [i, { geometry }] of again.entries()) {
      expect(geometry.attributes.position.array).toEqual(meshes[i].geometry.attributes.position.array);
    }
  });

  test('has numbers alone, and parts from dark to light', () => {
    for (const { geometry } of meshes) {
      expect([...geometry.attributes.position.array].every(Number.isFinite)).toBe(true);
      expect([...geometry.attributes.normal.array].every(Number.isFinite)).toBe(true);
    }
    const lightness = meshes.map(({ material }) => material.color.getHSL({ h: 0, s: 0, l: 0 }).l);
    expect(Math.min(...lightness)).toBeLessThan(0.05);
    expect(Math.max(...lightness)).toBeGreaterThan(0.7);
  });
});

test('the cloth hangs clear of its table and of the floor', () => {
  const [cloth, table] = makeDrapery().root.children as Mesh[];
  const { position } = cloth.geometry.attributes;
  const radius = new Box3().setFromObject(table).max.x;
  const hanging = Array.from({ length: position.count }, (_, i) => i).filter((i) => position.getY(i) < -0.02);
  expect(hanging.length).toBeGreaterThan(2000);
  for (const i of hanging) expect(Math.hypot(position.getX(i), position.getZ(i))).toBeGreaterThan(radius);
  expect(new Box3().setFromObject(cloth).min.y).toBeGreaterThan(-1.2);
});
