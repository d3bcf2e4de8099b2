import { BufferGeometry, Float32BufferAttribute, Group, Mesh, Uint8BufferAttribute } from 'three';
import { expect, test } from 'vitest';
import { mergeScene } from '../../../../../src/viewer/files/scenes/mergeScene.js';
import { repairGeometry, repairScene } from '../../../../../src/viewer/files/scenes/repairGeometry.js';

const triangle = (): BufferGeometry =>
  new BufferGeometry().setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0], 3));

const floats = (size: number, ...values: number[]): Float32BufferAttribute => new Float32BufferAttribute(values, size);

test('colours that are not numbers become white, other values zero, and good ones stay', () => {
  const geometry = triangle()
    .setAttribute('color', floats(3, 0.5, NaN, 0.25, 0, 0, 0, 1, Infinity, 1))
    .setAttribute('normal', floats(3, NaN, 0, 1, 0, 0, 1, 0, Infinity, -Infinity))
    .setAttribute('uv', floats(2, 0.5, NaN, 1, 0, -Infinity, 1))
    .setAttribute('tangent', new Uint8BufferAttribute([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12], 4));
  expect(repairGeometry(geometry)).toBe(true);
  expect([...geometry.attributes.color.array]).toEqual([0.5, 1, 0.25, 0, 0, 0, 1, 1, 1]);
  expect([...geometry.attributes.normal.array]).toEqual([0, 0, 0, 0, 0, 1, 0, 0, 0]);
  expect([...geometry.attributes.uv.array]).toEqual([0.5, 0, 1, 0, 0, 1]);
  expect(repairGeometry(geometry)).toBe(false);
});

test('a NaN in a morph target leaves the vertex in place', () => {
  const absolute = triangle();
  absolute.morphAttributes.position = [floats(3, 5, 5, 5, NaN, 7, 7, 8, 8, 8)];
  repairGeometry(absolute);
  expect([...absolute.morphAttributes.position[0].array]).toEqual([5, 5, 5, 1, 7, 7, 8, 8, 8]);
  const relative = triangle();
  relative.morphTargetsRelative = true;
  relative.morphAttributes.position = [floats(3, 5, 5, 5, NaN, 7, 7, 8, 8, 8)];
  repairGeometry(relative);
  expect([...relative.morphAttributes.position[0].array]).toEqual([5, 5, 5, 0, 7, 7, 8, 8, 8]);
});

test('every mesh of a scene is repaired, also its weights', () => {
  const shared = triangle().setAttribute('color', floats(3, ...new Array(9).fill(NaN)));
  const first = new Mesh(shared);
  const second = new Mesh(shared);
  second.morphTargetInfluences = [NaN, 0.5];
  repairScene(new Group().add(first, second));
  expect([...shared.attributes.color.array]).toEqual(new Array(9).fill(1));
  expect(second.morphTargetInfluences).toEqual([0, 0.5]);
});

test('a part without normals does not take those of the others', () => {
  const up = triangle().setAttribute('normal', floats(3, 0, 0, 1, 0, 0, 1, 0, 0, 1));
  const { normals } = mergeScene(new Group().add(new Mesh(triangle()), new Mesh(up)));
  // Zero normals are computed from the surface later.
  expect([...normals!]).toEqual([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
});
