import { expect, test } from 'vitest';
import { mapAxes } from '../../../../src/mesh/parallelProjection.js';

const COUNT = 256;
const axes = Array.from({ length: COUNT }, (_, i) => mapAxes(i));
const dot = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, value, i) => sum + value * b[i], 0);

test('the axes of a map are orthonormal', () => {
  for (const { right, up, towards } of axes) {
    for (const axis of [right, up, towards]) expect(dot(axis, axis)).toBeCloseTo(1, 12);
    for (const [a, b] of [
      [right, up],
      [right, towards],
      [up, towards],
    ])
      expect(dot(a, b)).toBeCloseTo(0, 12);
  }
});

test('directions are evenly spread over the upper half of the sphere', () => {
  const mean = [0, 1, 2].map((axis) => axes.reduce((sum, { towards }) => sum + towards[axis], 0) / COUNT);
  // Half a sphere has its middle at half its height.
  for (const [axis, value] of [0, 0.5, 0].entries()) expect(Math.abs(mean[axis] - value)).toBeLessThan(0.02);
  expect(Math.min(...axes.map(({ towards }) => towards[1]))).toBeGreaterThanOrEqual(0);
});

test('maps are rotated about their directions by evenly distributed angles', () => {
  // The angle from the horizontal.
  const turns = axes.map(({ right, up }) => Math.atan2(right[1], up[1]));
  const sectors = new Array(8).fill(0);
  for (const turn of turns) sectors[Math.floor((8 * (turn + Math.PI)) / (2 * Math.PI)) % 8]++;
  expect(Math.min(...sectors)).toBeGreaterThan(COUNT / 8 - 6);
  expect(Math.max(...sectors)).toBeLessThan(COUNT / 8 + 6);
});
