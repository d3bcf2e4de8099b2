import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import { expect, test } from 'vitest';
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
