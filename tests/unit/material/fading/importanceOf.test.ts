import { Group, Object3D } from 'three';
import { expect, test } from 'vitest';
import { importanceOf } from '../../../../src/material/fading/fading.js';

test('the importance of an object is its own, or that of the nearest object above it', () => {
  const mesh = new Object3D();
  const group = new Group().add(mesh);
  const scene = new Group().add(group);
  expect(importanceOf(mesh)).toBe(1);
  scene.userData.hatching = { importance: 0.5 };
  expect(importanceOf(mesh)).toBe(0.5);
  // Whether an object is hatched does not matter here.
  group.userData.hatching = true;
  expect(importanceOf(mesh)).toBe(0.5);
  mesh.userData.hatching = { importance: 0 };
  expect(importanceOf(mesh)).toBe(0);
});

test.each(['much', Number.NaN, -1, null])('%s is no importance', (importance) => {
  const mesh = new Object3D();
  mesh.userData.hatching = { importance };
  expect(importanceOf(mesh)).toBe(1);
});

test('nothing matters more than all', () => {
  const mesh = new Object3D();
  mesh.userData.hatching = { importance: 3 };
  expect(importanceOf(mesh)).toBe(1);
});
