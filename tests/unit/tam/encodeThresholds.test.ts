import fc from 'fast-check';
import { DataUtils } from 'three';
import { describe, expect, it } from 'vitest';
import { encodeThresholds, normalQuantile, toHalf } from '../../../src/tam/encodeThresholds.js';

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

describe('toHalf', () => {
  it('gives a half float within half a step of the number, as three decodes it', () => {
    const number = fc.oneof(
      fc.double({ min: -3, max: 3, noNaN: true }),
      fc.double({ min: -1e-4, max: 1e-4, noNaN: true }),
    );
    fc.assert(
      fc.property(number, (value) => {
        const step = Math.max(2 ** -24, 2 ** (Math.floor(Math.log2(Math.abs(value) || 1e-9)) - 10));
        expect(Math.abs(DataUtils.fromHalfFloat(toHalf(value)) - value)).toBeLessThanOrEqual(0.5001 * step);
      }),
    );
  });

  it.each([
    [0, 0],
    [1, 0x3c00],
    [-3, 0xc200],
    [2 ** -14, 0x0400],
    [2 ** -24, 1],
  ])('%f is %d', (value, bits) => {
    expect(toHalf(value)).toBe(bits);
  });
});

describe('encodeThresholds', () => {
  it('stores Φ⁻¹, no further out than ±3', () => {
    const { size, encoded } = encodeThresholds(2, new Float32Array([1e-6, 0.1, 0.5, 1 - 1e-6]));
    expect(size).toBe(2);
    const values = [...encoded].map((half) => DataUtils.fromHalfFloat(half));
    expect(values[0]).toBe(-3);
    expect(values[3]).toBe(3);
    expect(Math.abs(values[1] + 1.28155)).toBeLessThan(1.5e-3);
    expect(Math.abs(values[2])).toBeLessThan(1e-3);
  });
});
