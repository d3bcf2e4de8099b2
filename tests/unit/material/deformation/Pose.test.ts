import { Bone, BoxGeometry, Mesh, Skeleton, SkinnedMesh } from 'three';
import { expect, test } from 'vitest';
import { Pose } from '../../../../src/material/deformation/Deformation.js';

const skinned = () => {
  const mesh = new SkinnedMesh(new BoxGeometry());
  const bones = [new Bone(), new Bone()];
  mesh.add(...bones);
  mesh.bind(new Skeleton(bones));
  mesh.skeleton.update();
  return mesh;
};

test('differs the first time, and then only with the bones', () => {
  const pose = new Pose();
  const mesh = skinned();
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
  mesh.skeleton.bones[1].position.x = 0.1;
  mesh.updateMatrixWorld(true);
  mesh.skeleton.update();
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
});

test('differs with the binding', () => {
  const pose = new Pose();
  const mesh = skinned();
  pose.update(mesh);
  mesh.bindMatrix.makeScale(2, 2, 2);
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
  mesh.bindMatrixInverse.makeScale(0.1, 0.1, 0.1);
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
});

test('differs with influences, in double precision, and with their number', () => {
  const pose = new Pose();
  const mesh = new Mesh(new BoxGeometry());
  mesh.morphTargetInfluences = [0.1, 1 / 3];
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
  mesh.morphTargetInfluences[1] = 0.4;
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
  mesh.morphTargetInfluences.push(0);
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
  mesh.morphTargetInfluences.length = 1;
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
});

test('of a rigid mesh differs once', () => {
  const pose = new Pose();
  const mesh = new Mesh(new BoxGeometry());
  expect([pose.update(mesh), pose.update(mesh)]).toEqual([true, false]);
});
