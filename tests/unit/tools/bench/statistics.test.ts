import { describe, expect, test } from 'vitest';
import { fitExponent, median, medianInterval, ratios, verdict } from '../../../../tools/bench/statistics.mjs';

const upTo = (n: number): number[] => Array.from({ length: n }, (_, i) => i + 1);

test('the median is the middle value, or lies between the two middle ones', () => {
  expect(median([3, 1, 2])).toBe(2);
  expect(median([4, 1, 3, 2])).toBe(2.5);
});

describe('the interval of the median', () => {
  // The ranks are those of the tables of the sign test.
  test.each([
    [6, 1],
    [8, 1],
    [9, 2],
    [15, 4],
    [25, 8],
    [31, 10],
  ])('of %i values runs from the %i. smallest to the same from the top', (n, rank) => {
    expect(medianInterval(upTo(n).reverse())).toEqual([(n + 1) / 2, rank, n + 1 - rank]);
  });

  test('of few values is all of them', () => {
    expect(medianInterval([7])).toEqual([7, 7, 7]);
    expect(medianInterval(upTo(5))).toEqual([3, 1, 5]);
  });

  test('holds the true median in at least 95 of 100 cases', () => {
    let state = 1;
    const random = (): number => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return state / 2 ** 32;
    };
    let held = 0;
    for (let trial = 0; trial < 2000; trial++) {
      const [, low, high] = medianInterval(Array.from({ length: 15 }, () => random() ** 3));
      if (low! <= 0.125 && 0.125 <= high) held++;
    }
    expect(held / 2000).toBeGreaterThan(0.95);
    expect(held / 2000).toBeLessThan(0.98);
  });
});

test('ratios are taken within a turn', () => {
  expect(ratios([2, 30], [1, 10])).toEqual([2, 3]);
});

test('code is slower or faster only with its whole interval', () => {
  expect(verdict([1.1, 1.04, 1.2])).toBe('slower');
  expect(verdict([1.1, 1.03, 1.2])).toBe('same');
  expect(verdict([0.9, 0.8, 0.96])).toBe('faster');
  expect(verdict([0.9, 0.8, 0.98])).toBe('same');
});

describe('the exponent of growth', () => {
  test('of an exact power law is exact', () => {
    const [exponent, low, high] = fitExponent(upTo(5).map((n) => [n, 7 * n ** 1.5]));
    for (const value of [exponent, low, high]) expect(value).toBeCloseTo(1.5, 10);
  });

  test('has the interval of the regression line', () => {
    // x = 0, 1, 2 and y = 0, 1, 1: slope 1/2, residual sum 1/6, one degree of freedom.
    const [exponent, low, high] = fitExponent([
      [1, 1],
      [Math.E, Math.E],
      [Math.E ** 2, Math.E],
    ]);
    const margin = 12.71 * Math.sqrt(1 / 6 / 2);
    expect(exponent).toBeCloseTo(0.5, 10);
    expect(low).toBeCloseTo(0.5 - margin, 10);
    expect(high).toBeCloseTo(0.5 + margin, 10);
  });
});
