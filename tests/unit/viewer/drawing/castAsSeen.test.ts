import { BoxGeometry, DoubleSide, FrontSide, Mesh, MeshBasicMaterial, PlaneGeometry, type Side } from 'three';
import { expect, test } from 'vitest';
import { castAsSeen } from '../../../../src/viewer/drawing/castAsSeen.js';

/** A box whose faces look outward, or inward. */
function box(size: number, isInward: boolean, side: Side = FrontSide): Mesh<BoxGeometry, MeshBasicMaterial> {
  const geometry = new BoxGeometry(size, size, size);
  if (isInward) geometry.index!.array.reverse();
  return new Mesh(geometry, new MeshBasicMaterial({ side }));
}

/** The sides that meshes cast shadows with. */
function sidesOf(...meshes: Mesh<BoxGeometry | PlaneGeometry, MeshBasicMaterial>[]): (Side | null)[] {
  for (const mesh of meshes) mesh.updateMatrixWorld();
  castAsSeen(meshes);
  return meshes.map(({ material }) => material.shadowSide);
}

test('all of a room of single sides casts with the sides that are seen, its furniture too', () => {
  expect(sidesOf(box(2, true), box(0.5, false))).toEqual([FrontSide, FrontSide]);
});

test('a mirrored room is a room, and a mirrored body none', () => {
  const mirrored = box(2, false);
  mirrored.scale.x = -1;
  // A negative scale alone turns no side, as in three.js.
  expect(sidesOf(mirrored)).toEqual([null]);
  const inward = box(2, true);
  inward.scale.x = -1;
  expect(sidesOf(inward)).toEqual([FrontSide]);
});

test('bodies, sheets, a hollow body and a room of double sides cast as in three.js', () => {
  expect(sidesOf(box(2, false))).toEqual([null]);
  expect(sidesOf(box(2, false), box(1.8, true))).toEqual([null, null]);
  expect(sidesOf(box(2, true, DoubleSide), box(0.5, false))).toEqual([null, null]);
  const sheet = new Mesh(new PlaneGeometry(2, 2), new MeshBasicMaterial());
  expect(sidesOf(sheet)).toEqual([null]);
});
