import { describe, expect, it } from 'vitest';
import { random } from '../../../src/strokes/random.js';

const take = (seed: number, count: number): number[] => {
  const next = random(seed);
  return Array.from({ length: count }, next);
};

describe('random', () => {
  it('repeats with the same seed only', () => {
    expect(take(7, 50)).toEqual(take(7, 50));
    expect(take(7, 50)).not.toEqual(take(8, 50));
  });

  it('never changes its numbers, since saved seeds must keep their drawings', () => {
    expect(take(1, 3).map((value) => Math.round(value * 2 ** 32))).toEqual([1580013426, 350525680, 3524174333]);
  });

  it('spreads evenly over [0, 1), neighbours independent', () => {
    const values = take(3, 100_000);
    const counts = new Array<number>(64).fill(0);
    for (let i = 0; i + 1 < values.length; i += 2) {
      expect(values[i] >= 0 && values[i] < 1).toBe(true);
      counts[8 * Math.floor(8 * values[i]) + Math.floor(8 * values[i + 1])]++;
    }
    const expected = 50_000 / 64;
    const chiSquare = counts.reduce((sum, count) => sum + (count - expected) ** 2 / expected, 0);
    // 63 degrees of freedom: above 104 once in a thousand.
    expect(chiSquare).toBeLessThan(104);
  });
});
