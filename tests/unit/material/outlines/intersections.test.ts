import {
  BoxGeometry,
  Group,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Scene,
  SphereGeometry,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { expect, test } from 'vitest';
import { outlineDataOf } from '../../../../src/material/geometry/OutlineData.js';
import type { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { drawnParts } from '../../../../src/material/outlines/loadIntersections.js';
import { OutlineParts, unlistedPart } from '../../../../src/material/outlines/OutlineParts.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';

/** Lines where meshes meet, as parts of their outlines. */

const ball = (x = 0) =>
  new Mesh(new SphereGeometry(0.5, 32, 16).rotateZ(0.3).translate(x, 0, 0), new MeshBasicMaterial());

async function hatched(...meshes: Mesh[]) {
  const group = new Group().add(...meshes);
  const scene = new Scene().add(group);
  const { outlines } = await applyHatching(group, { preset: 'engraving', outlines: { intersections: true } });
  return { group, scene, outlines };
}

/** The segments of lines that outlines draw beside their own. */
function segmentsOf(outlines: HatchingOutlines): number {
  const { mesh } = outlines;
  mesh!.updateWorldMatrix(true, false);
  const own = new OutlineParts().of(mesh!, outlineDataOf(mesh!.geometry)!);
  const more = drawnParts(outlines, own, unlistedPart).slice(own.length);
  return more.reduce((sum, { data }) => sum + data.edgeCount, 0);
}

test('applyHatching waits for them, and one of two meshes draws them', async () => {
  const { outlines } = await hatched(ball(-0.3), ball(0.3));
  const [first, second] = outlines.map(segmentsOf);
  expect(first).toBeGreaterThan(30);
  expect(second).toBe(0);
});

test('they stay while meshes move together, and go where one moves, is hidden or turned off', async () => {
  const { group, outlines } = await hatched(ball(-0.3), ball(0.3));
  const [one, other] = outlines;
  const all = segmentsOf(one);
  group.position.set(1, 2, 3);
  group.rotation.set(0.3, 0.2, 0.1);
  group.updateMatrixWorld(true);
  expect(segmentsOf(one)).toBe(all);
  other.mesh!.position.y = 0.01;
  other.mesh!.updateMatrixWorld(true);
  expect(segmentsOf(one)).toBe(0);
  other.mesh!.position.y = 0;
  other.mesh!.updateMatrixWorld(true);
  expect(segmentsOf(one)).toBe(all);
  other.mesh!.visible = false;
  expect(segmentsOf(one)).toBe(0);
  other.mesh!.visible = true;
  for (const { material } of [one, other]) {
    material.intersections = false;
    expect(segmentsOf(one)).toBe(0);
    material.intersections = true;
  }
});

test('parts of one mesh have them, and what has several places or shapes has none', async () => {
  const both = new Mesh(mergeGeometries([ball(-0.3).geometry, ball(0.3).geometry]), new MeshBasicMaterial());
  const { outlines } = await hatched(both);
  expect(segmentsOf(outlines[0])).toBeGreaterThan(30);
  const boxes = new InstancedMesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshBasicMaterial(), 2);
  for (const i of [0, 1]) boxes.setMatrixAt(i, new Matrix4().makeTranslation(i - 0.5, 0, 0));
  const among = await hatched(boxes, ball());
  expect(among.outlines.map(segmentsOf)).toEqual([0, 0]);
});

test('the scene is told when there are new ones', async () => {
  const { scene, outlines } = await hatched(ball(-0.3), ball(0.3));
  const [one, other] = outlines;
  const told = new Promise((resolve) => scene.addEventListener('intersections' as 'added', resolve));
  other.mesh!.position.x = 0.1;
  other.mesh!.updateMatrixWorld(true);
  expect(segmentsOf(one)).toBe(0);
  segmentsOf(other);
  await told;
  expect(segmentsOf(one)).toBeGreaterThan(30);
});

test('what is seen through holds them, as firm as the lines of the other, and one mesh alone after a change', async () => {
  const [solid, glass] = [ball(-0.3), ball(0.3)];
  const clear = { transparent: true, opacity: 0.3 };
  Object.assign(glass.material, clear);
  const { scene, outlines } = await hatched(solid, glass);
  const [ofSolid, ofGlass] = outlines;
  const surfaceOf = ({ mesh }: HatchingOutlines): Material => mesh!.material as Material;
  const surfaces = (of: HatchingOutlines): Material[] => {
    const own = new OutlineParts().of(of.mesh!, outlineDataOf(of.mesh!.geometry)!);
    return drawnParts(of, own, unlistedPart)
      .slice(own.length)
      .map(({ surface }) => surface);
  };
  expect(segmentsOf(ofSolid)).toBe(0);
  expect(segmentsOf(ofGlass)).toBeGreaterThan(30);
  expect(surfaces(ofGlass)).toEqual([surfaceOf(ofSolid)]);
  surfaceOf(ofGlass).opacity = 1;
  expect(surfaces(ofGlass)).toEqual([surfaceOf(ofGlass)]);
  Object.assign(surfaceOf(ofSolid), clear);
  Object.assign(surfaceOf(ofGlass), { transparent: false });
  const told = new Promise((resolve) => scene.addEventListener('intersections' as 'added', resolve));
  solid.position.x = 0.1;
  solid.updateMatrixWorld(true);
  for (const each of outlines) segmentsOf(each);
  await told;
  expect(segmentsOf(ofSolid)).toBeGreaterThan(30);
  expect(segmentsOf(ofGlass)).toBe(0);
  expect(surfaces(ofSolid)).toEqual([surfaceOf(ofGlass)]);
});
