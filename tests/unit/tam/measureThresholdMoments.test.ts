import { describe, expect, it } from 'vitest';
import { encodeThresholds } from '../../../src/tam/encodeThresholds.js';
import { generateThresholds } from '../../../src/tam/generateThresholds.js';
import { measureThresholdMoments } from '../../../src/tam/measureThresholdMoments.js';
import { random as seeded } from '../../../src/tam/random.js';

/** Thresholds in random places: neighbouring texels know nothing of each other. */
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
  it('of noise is what bilinear weights leave: (2/3)² of the variance, and nothing in common between levels', () => {
    const { variance, covariance } = measureThresholdMoments([noise(64, 1), noise(32, 2)]);
    expect(variance).toBeCloseTo(4 / 9, 1);
    expect(Math.abs(covariance)).toBeLessThan(0.05);
  });

  it('of a level beside itself is its variance', () => {
    const level = noise(32, 3);
    const { variance, covariance } = measureThresholdMoments([level, level]);
    expect(covariance).toBeCloseTo(variance, 6);
  });

  it('of a drawn map lies between: smooth across strokes, and levels nest', () => {
    const task = generateThresholds({ size: 64 });
    let step = task.next();
    while (!step.done) step = task.next();
    const { variance, covariance } = measureThresholdMoments(step.value);
    expect(variance).toBeGreaterThan(0.7);
    expect(variance).toBeLessThan(1);
    expect(covariance).toBeGreaterThan(0.1);
    expect(covariance).toBeLessThan(variance);
  });

  it('of one level has no covariance', () => {
    expect(measureThresholdMoments([noise(16, 4)]).covariance).toBe(0);
  });
});
