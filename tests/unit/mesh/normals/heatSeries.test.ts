import { expect, test } from 'vitest';
import { heatSeries } from '../../../../src/mesh/normals/diffuse.js';

/** Σ cₖ·Tₖ(x), with Tₖ(cos a) = cos(k·a). */
const valueAt = (coefficients: readonly number[], x: number): number =>
  coefficients.reduce((sum, coefficient, k) => sum + coefficient * Math.cos(k * Math.acos(x)), 0);

test.each([1e-5, 0.1, 1, 7, 100, 4000])('is the flow of heat for %d steps', (time) => {
  const coefficients = heatSeries(time, 1e-3);
  for (let x = -1; x <= 1; x += 1 / 64) {
    expect(Math.abs(valueAt(coefficients, x) - Math.exp(-time * (1 - x)))).toBeLessThan(2e-3);
  }
  expect(valueAt(coefficients, 1)).toBeCloseTo(1, 12);
});

test('takes the square root of the steps', () => {
  expect(heatSeries(100, 0.02).length).toBeLessThan(30);
  expect(heatSeries(10_000, 0.02).length).toBeLessThan(280);
});
