import { expect, test } from 'vitest';
import { triangleGroups } from '../../../../src/material/geometry/prepareHatchingGeometry.js';

const group = (start: number, count: number, materialIndex?: number) => ({ start, count, materialIndex });

test('there are none if all triangles are in one group', () => {
  expect(triangleGroups({ start: 0, count: 12, groups: [] })).toBeNull();
  expect(triangleGroups({ start: 0, count: 12, groups: [group(0, 12, 3)] })).toBeNull();
});

test('each triangle has its material index plus 1, those outside of all groups 0', () => {
  const groups = [group(0, 3, 2), group(3, 6, 0), group(12, 3, 5)];
  expect(triangleGroups({ start: 0, count: 18, groups })).toEqual(new Uint16Array([3, 1, 1, 0, 6, 0]));
});

test('the draw range does not count: groups are relative to it', () => {
  const groups = [group(0, 3, 0), group(3, 3, 1)];
  expect(triangleGroups({ start: 300, count: 6, groups })).toEqual(new Uint16Array([1, 2]));
});

test('two groups of one material are one, and a group without a number has the first material', () => {
  const groups = [group(0, 3, 0), group(3, 3), group(6, 3, 1)];
  expect(triangleGroups({ start: 0, count: 9, groups })).toEqual(new Uint16Array([1, 1, 2]));
});
