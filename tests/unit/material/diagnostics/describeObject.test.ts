import { Group, Mesh, Scene } from 'three';
import { expect, test } from 'vitest';
import { describeObject } from '../../../../src/material/diagnostics/describeObject.js';

test('an object is named by its type, its name and its path', () => {
  const scene = new Scene();
  const arm = Object.assign(new Group(), { name: 'arm' });
  const [named, nameless] = [Object.assign(new Mesh(), { name: 'hand' }), new Mesh()];
  scene.add(new Group(), new Group().add(arm.add(named, nameless)));
  expect(describeObject(named)).toBe('Mesh "hand" at Scene/Group[1]/arm/hand');
  expect(describeObject(nameless)).toBe('Mesh at Scene/Group[1]/arm/Mesh[1]');
  expect(describeObject(scene)).toBe('Scene');
  expect(describeObject(Object.assign(new Mesh(), { name: 'alone' }))).toBe('Mesh "alone"');
});

test('one that is its own descendant is named, too', () => {
  const group = new Group();
  group.add(group.clone());
  group.parent = group.children[0];
  expect(describeObject(group)).toBe('Group at Group[0]/Group[-1]');
});
