import { describe, expect, it } from 'vitest';
import { blurToroidal } from '../../../src/strokes/blurToroidal.js';

describe('blurToroidal', () => {
  it.each([0, 1, 3, 5])('spreads a texel into a tent of radius %i, around the corner', (radius) => {
    const size = 16;
    const field = new Float32Array(size * size);
    field[0] = 1;
    const blurred = blurToroidal(field, size, radius);
    const tent = (x: number): number => Math.max(0, radius + 1 - Math.min(x, size - x)) / (radius + 1) ** 2;
    for (let i = 0; i < field.length; i++) {
      expect(blurred[i]).toBeCloseTo(tent(Math.floor(i / size)) * tent(i % size), 6);
    }
  });

  it('has a radius of its own along rows', () => {
    const field = new Float32Array(256);
    field[5 * 16 + 8] = 1;
    const blurred = blurToroidal(field, 16, 0, 3);
    expect(blurred[5 * 16 + 10]).toBeCloseTo(2 / 16, 6);
    expect(blurred.subarray(0, 5 * 16).every((value) => value === 0)).toBe(true);
  });

  it('keeps the mean, even where the tent is wider than the field', () => {
    const field = Float32Array.from({ length: 16 }, (_, i) => i);
    const blurred = blurToroidal(field, 4, 20);
    expect(blurred.reduce((a, b) => a + b)).toBeCloseTo(120, 3);
    expect(Math.max(...blurred) - Math.min(...blurred)).toBeLessThan(0.2);
  });
});
