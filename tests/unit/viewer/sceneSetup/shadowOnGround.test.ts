import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { shadowOnGround } from '../../../../src/viewer/sceneSetup/groundShadow.js';

const expectPoints = (points: number[], expected: number[]): void => {
  expect(points).toHaveLength(expected.length);
  for (const [i, value] of points.entries()) expect(value).toBeCloseTo(expected[i], 9);
};

test('a sun casts shadows along its direction, as long as points are high', () => {
  expectPoints(shadowOnGround([0, 1, 0, 2, 0, 1, 0, -1, 0], new Vector3(-2, 1, 0.5), true, -1), [
    ...[4, -1, -1],
    ...[4, -1, 0.5],
    ...[0, -1, 0],
  ]);
});

test('a lamp casts longer shadows of more distant points, and none of points at its own height', () => {
  const lamp = new Vector3(0, 3, 0);
  expectPoints(shadowOnGround([0, 0, 0, 1, 0, 0, 2, 0, -1, 1, 3, 0, 1, 4, 0], lamp, false, -1), [
    ...[0, -1, 0],
    ...[4 / 3, -1, 0],
    ...[8 / 3, -1, -4 / 3],
  ]);
});

test('shadows of a low sun end, and one from below has none', () => {
  const [x, y, z] = shadowOnGround([0, 1, 0], new Vector3(-1, 1e-6, 0), true, 0);
  expect([y, z]).toEqual([0, 0]);
  expect(x).toBeGreaterThan(5);
  expect(x).toBeLessThan(50);
  expect(shadowOnGround([0, 1, 0], new Vector3(-1, 0, 0), true, 0)).toEqual([]);
  expect(shadowOnGround([0, 1, 0], new Vector3(-1, -1, 0), true, 0)).toEqual([]);
});
