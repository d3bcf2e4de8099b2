import { describe, expect, it } from 'vitest';
import { encodeThresholds, normalQuantile } from '../../../../src/strokes/tamImages/thresholds.js';

describe('normalQuantile', () => {
  it.each([
    [0.5, 0],
    [0.841344746, 1],
    [0.977249868, 2],
    [0.0013498980316, -3],
    [0.975, 1.959963985],
    [0.1, -1.281551566],
  ])('Φ⁻¹(%f) = %f', (p, expected) => {
    expect(Math.abs(normalQuantile(p) - expected)).toBeLessThan(5e-4);
  });

  it('is odd about one half', () => {
    for (const p of [0.25, 0.125, 0.0625]) expect(normalQuantile(1 - p)).toBe(-normalQuantile(p));
  });
});

describe('encodeThresholds', () => {
  it('stores Φ⁻¹ from −3 to 3 in bytes, within half a step, clamped beyond', () => {
    const thresholds = new Float32Array([1e-6, 0.1, 0.3, 0.5, 0.8, 1 - 1e-6]);
    const { size, encoded } = encodeThresholds(2, thresholds);
    expect(size).toBe(2);
    const values = [...encoded].map((byte) => (6 * byte) / 255 - 3);
    expect(values[0]).toBe(-3);
    expect(values.at(-1)).toBe(3);
    thresholds.slice(1, -1).forEach((threshold, i) => {
      expect(Math.abs(values[i + 1] - normalQuantile(threshold))).toBeLessThanOrEqual(3 / 255 + 1e-6);
    });
  });

  it('keeps a threshold and its complement mirror images', () => {
    const thresholds = Float32Array.from({ length: 64 }, (_, i) => (i + 0.5) / 64);
    const { encoded } = encodeThresholds(8, thresholds);
    for (let i = 0; i < 64; i++) expect(encoded[i] + encoded[63 - i]).toBe(255);
  });
});
