import fc from 'fast-check';
import { DataUtils } from 'three';
import { expect, test } from 'vitest';
import { halfFloat } from '../../../../src/mesh/bake/packOutlines.js';

const decode = (bits: number): number => DataUtils.fromHalfFloat(bits);

const LARGEST = 65504;
const LEAST_NORMAL = 2 ** -14;

test('every normal half float is kept to the last bit', () => {
  const changed: number[] = [];
  for (let bits = 0; bits < 2 ** 16; bits++) {
    const exponent = (bits >> 10) & 31;
    if (exponent > 0 && exponent < 31 && halfFloat(decode(bits)) !== bits) changed.push(bits);
  }
  expect(changed).toEqual([]);
  expect([halfFloat(0), halfFloat(-0)]).toEqual([0, 0x8000]);
});

test('numbers in range are rounded to the nearest half float, within one bit of three.js', () => {
  const value = fc
    .tuple(fc.double({ min: -14, max: 15.99, noNaN: true }), fc.boolean())
    .map(([exponent, isNegative]) => Math.min(2 ** exponent, LARGEST) * (isNegative ? -1 : 1));
  fc.assert(
    fc.property(value, (x) => {
      const bits = halfFloat(x);
      expect(Math.abs(decode(bits) - x)).toBeLessThanOrEqual(1.0001 * 2 ** -11 * Math.abs(x));
      expect(Math.abs(bits - DataUtils.toHalfFloat(x))).toBeLessThanOrEqual(1);
      expect(Math.sign(decode(bits))).toBe(Math.sign(x));
    }),
    { seed: 20080, numRuns: 1000 },
  );
});

test('rounds half up, across powers of two too', () => {
  expect(decode(halfFloat(1 + 0.49 * 2 ** -10))).toBe(1);
  expect(decode(halfFloat(1 + 0.51 * 2 ** -10))).toBe(1 + 2 ** -10);
  expect(decode(halfFloat(2 - 0.49 * 2 ** -10))).toBe(2);
  expect(decode(halfFloat(-2 + 0.51 * 2 ** -10))).toBe(-2 + 2 ** -10);
});

test.each([
  [65504, LARGEST],
  [65519, LARGEST],
  [65521, LARGEST],
  [1e6, LARGEST],
  [3e38, LARGEST],
  [1e300, LARGEST],
  [Infinity, LARGEST],
])('%d is clamped to %d, and its negative to the negative', (value, expected) => {
  expect(decode(halfFloat(value))).toBe(expected);
  expect(decode(halfFloat(-value))).toBe(-expected);
});

test.each([0.99 * LEAST_NORMAL, 1e-5, 6e-8, 1e-40, 1e-300])('%d is too small, and becomes 0', (value) => {
  expect(halfFloat(value)).toBe(0);
  expect(halfFloat(-value)).toBe(0x8000);
  expect(decode(halfFloat(LEAST_NORMAL))).toBe(LEAST_NORMAL);
});
