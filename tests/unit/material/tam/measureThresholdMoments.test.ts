import { describe, expect, it } from 'vitest';
import { measureThresholdMoments, pairThresholdLevels } from '../../../../src/material/tam/thresholds.js';
import { random as seeded } from '../../../../src/strokes/random.js';
import { generateThresholds } from '../../../../src/strokes/tamImages/generateThresholds.js';
import { encodeThresholds } from '../../../../src/strokes/tamImages/thresholds.js';

/** Random thresholds: neighbouring texels are independent. */
function noise(size: number, seed: number) {
  const random = seeded(seed);
  const order = Array.from({ length: size * size }, (_, i) => ({ i, key: random() })).sort((a, b) => a.key - b.key);
  const thresholds = new Float32Array(size * size);
  order.forEach(({ i }, rank) => {
    thresholds[i] = (rank + 0.5) / (size * size);
  });
  return encodeThresholds(size, thresholds);
}

describe('measureThresholdMoments', () => {
  it('of noise is (2/3)² of the variance, by bilinear weights, and has no covariance between levels', () => {
    const { variance, covariance } = measureThresholdMoments(pairThresholdLevels([noise(64, 1), noise(32, 2)]));
    expect(variance).toBeCloseTo(4 / 9, 1);
    expect(Math.abs(covariance)).toBeLessThan(0.05);
  });

  it('of a level paired with itself is its variance', () => {
    const { size, encoded } = noise(32, 3);
    const pair = { size, own: encoded, coarser: encoded };
    const { variance, coarserVariance, covariance } = measureThresholdMoments([pair, pair]);
    expect(coarserVariance).toBeCloseTo(variance, 6);
    expect(covariance).toBeCloseTo(variance, 6);
  });

  it('of a drawn map is between the two: smooth across strokes, with nested levels', () => {
    const task = generateThresholds({ size: 64 });
    let step = task.next();
    while (!step.done) step = task.next();
    const { variance, coarserVariance, covariance } = measureThresholdMoments(pairThresholdLevels(step.value));
    expect(variance).toBeGreaterThan(0.7);
    expect(variance).toBeLessThan(1);
    // Interpolated twice, it is a little smoother.
    expect(coarserVariance).toBeGreaterThan(0.7);
    expect(coarserVariance).toBeLessThan(variance);
    expect(covariance).toBeGreaterThan(0.1);
    expect(covariance).toBeLessThan(variance);
  });

  it('of one level has no covariance', () => {
    expect(measureThresholdMoments(pairThresholdLevels([noise(16, 4)]))).toMatchObject({
      coarserVariance: 0,
      covariance: 0,
    });
  });
});
