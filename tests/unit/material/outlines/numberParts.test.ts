import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, Scene } from 'three';
import { expect, test } from 'vitest';
import { outlineDataOf } from '../../../../src/material/geometry/OutlineData.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { NumberedPart, numberParts } from '../../../../src/material/outlines/NumberedPart.js';

/** Numbers of parts, by which pixels of the screen know what moves together. */

const geometry = await prepareHatchingGeometry(new BoxGeometry(), { outlines: true });

function partOf(mesh: Mesh): NumberedPart {
  const outlines = new HatchingOutlines(mesh, { intersections: true });
  mesh.add(outlines);
  const part = new NumberedPart(outlines);
  mesh.updateWorldMatrix(true, false);
  part.noteSearch(mesh.matrixWorld, outlineDataOf(geometry)!);
  return part;
}

/** Three boxes, two of them in a group. */
function boxes() {
  const meshes = [0, 1, 2].map((x) => new Mesh(geometry, new MeshBasicMaterial()).translateX(0.5 * x));
  const group = new Group().add(meshes[1], meshes[2]);
  const scene = new Scene().add(meshes[0], group);
  return { meshes, group, scene, parts: meshes.map(partOf) };
}

const numbersOf = (parts: readonly NumberedPart[]): number[] => parts.map(({ number }) => number);

test('parts that rest share a number, and those that have moved together share another', () => {
  const { meshes, group, scene, parts } = boxes();
  expect(numberParts(parts, scene)).toBe(1);
  expect(numbersOf(parts)).toEqual([1, 1, 1]);
  group.rotation.set(0.1, 0.2, 0.3);
  group.position.x = 1;
  scene.updateMatrixWorld(true);
  expect(numberParts(parts, scene)).toBe(2);
  expect(numbersOf(parts)).toEqual([1, 2, 2]);
  meshes[2].position.y = 0.1;
  scene.updateMatrixWorld(true);
  expect(numberParts(parts, scene)).toBe(3);
  expect(numbersOf(parts)).toEqual([1, 2, 3]);
  scene.position.set(5, 0, 0);
  for (const part of parts) part.noteSearch(part.outlines.mesh!.matrixWorld, outlineDataOf(geometry)!);
  scene.updateMatrixWorld(true);
  expect(numberParts(parts, scene)).toBe(1);
});

test('each instance has a number of its own; what is hidden, elsewhere or cut out has none', () => {
  const { meshes, group, scene, parts } = boxes();
  const instances = new InstancedMesh(geometry, new MeshBasicMaterial(), 3);
  for (const i of [0, 1, 2]) instances.setMatrixAt(i, new Matrix4());
  scene.add(instances);
  parts.unshift(partOf(instances));
  expect(numberParts(parts, scene)).toBe(4);
  expect(numbersOf(parts)).toEqual([2, 1, 1, 1]);
  (meshes[0].material as MeshBasicMaterial).alphaTest = 0.5;
  group.visible = false;
  instances.removeFromParent();
  expect(numberParts(parts, scene)).toBe(0);
  expect(numbersOf(parts)).toEqual([0, 0, 0, 0]);
});

test('a part that is seen through is numbered as others are', () => {
  const { meshes, scene, parts } = boxes();
  const [glass] = meshes;
  Object.assign(glass.material, { transparent: true, depthWrite: false });
  glass.position.y = 0.1;
  scene.updateMatrixWorld(true);
  expect(numberParts(parts, scene)).toBe(2);
  expect(numbersOf(parts)).toEqual([2, 1, 1]);
  expect(parts.map(({ isClear }) => isClear)).toEqual([true, false, false]);
});
